#include "silhouette/recording/first_images.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "silhouette/background/light_gain.h"
#include "silhouette/recording/color_candidates.h"

namespace markerless_mocap {
namespace {

/// Mean fraction of the image in which something moves. Empty rooms have 0, with much noise 0.0001;
/// somebody with the hands on the hips 0.0014, a person who walks 0.055 and more.
constexpr double kMotionFraction = 0.001;
/// Fraction of the image of a region that counts.
constexpr double kLeftFraction = 0.002;
constexpr float kChange = 25;           ///< grey levels
constexpr float kConstantShare = 0.8f;  ///< of the later images
constexpr size_t kFewest = 4;           ///< later images to decide by
constexpr int kOpen = 3;
constexpr int kRing = 7;               ///< width of the ring around a region, px
constexpr int kAround = 5;             ///< what detail is compared with, px
constexpr double kSameDetail = 0.5;    ///< correlation of a surface's detail in other light
constexpr float kConstantRing = 0.8f;  ///< fraction of the ring that is constant later

std::vector<PixelCandidates> candidatesOf(const std::vector<cv::Mat>& images,
                                          const cv::Mat& reference) {
  SceneSamples samples;
  samples.size = reference.size();
  for (const cv::Mat& image : images) {
    samples.colors.push_back(image / estimateLightGain(image, reference).gain);
    samples.moving.push_back(cv::Mat::zeros(samples.size, CV_8UC1));
  }
  return findCandidates(samples);
}

/// The most frequent colours, and where they are constant.
struct Scene {
  cv::Mat color;     ///< CV_8UC3
  cv::Mat constant;  ///< CV_8UC1
};

Scene sceneOf(const std::vector<PixelCandidates>& candidates, const cv::Size& size) {
  Scene scene{cv::Mat(size, CV_8UC3), cv::Mat(size, CV_8UC1)};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const ColorCandidate& mode = candidates[size_t(y) * size.width + x].colors[0];
      scene.color.at<cv::Vec3b>(y, x) = mode.color;
      scene.constant.at<uint8_t>(y, x) = mode.share >= kConstantShare ? 255 : 0;
    }
  return scene;
}

/// Magnitude of the gradient, summed over channels.
cv::Mat edgesOf(const cv::Mat& color) {
  cv::Mat dx, dy, edges;
  cv::Sobel(color, dx, CV_32F, 1, 0);
  cv::Sobel(color, dy, CV_32F, 0, 1);
  edges = cv::abs(dx) + cv::abs(dy);
  cv::transform(edges, edges, cv::Matx13f(1, 1, 1));
  return edges;
}

/// Grey levels above or below those around.
cv::Mat detailOf(const cv::Mat& color) {
  cv::Mat grey, around;
  color.convertTo(grey, CV_32F);
  cv::transform(grey, grey, cv::Matx13f(1, 1, 1));
  cv::blur(grey, around, {kAround, kAround});
  return grey - around;
}

/// Whether the region shows the same surface before and after, only under other light: sun that
/// wanders, a lamp, a shadow.
bool isOtherLight(const cv::Mat& region, const Scene& before, const Scene& after) {
  cv::Mat inner;
  cv::erode(region, inner, cv::Mat::ones(kAround, kAround, CV_8UC1));
  const cv::Mat a = detailOf(before.color), b = detailOf(after.color);
  const double both = cv::mean(a.mul(b), inner)[0];
  return both >
         kSameDetail * std::sqrt(cv::mean(a.mul(a), inner)[0] * cv::mean(b.mul(b), inner)[0]);
}

cv::Mat changedPixels(const Scene& before, const Scene& after) {
  cv::Mat difference, squares;
  cv::subtract(before.color, after.color, difference, cv::noArray(), CV_32F);
  cv::multiply(difference, difference, difference);
  cv::transform(difference, squares, cv::Matx13f(1, 1, 1));
  cv::Mat changed = (squares > kChange * kChange) & after.constant;
  const cv::Mat element = cv::getStructuringElement(cv::MORPH_ELLIPSE, {kOpen, kOpen});
  cv::morphologyEx(changed, changed, cv::MORPH_OPEN, element);
  return changed;
}

/// Whether the region is the outline of something in the first images, and nothing moves around it
/// later: around a person who stays on the spot something always does, and what was brought in has
/// its outline later.
bool hasLeft(const cv::Mat& region, const Scene& before, const Scene& after) {
  const cv::Mat element = cv::getStructuringElement(cv::MORPH_ELLIPSE, {kRing, kRing});
  cv::Mat outer, inner;
  cv::dilate(region, outer, element);
  cv::erode(region, inner, element);
  const cv::Mat around = outer & ~region, outline = outer & ~inner;
  if (cv::countNonZero(around & after.constant) < kConstantRing * cv::countNonZero(around))
    return false;
  return cv::mean(edgesOf(before.color), outline)[0] > cv::mean(edgesOf(after.color), outline)[0];
}

}  // namespace

bool showMotion(const std::vector<cv::Mat>& moving) {
  double pixels = 0, all = 0;
  for (const cv::Mat& mask : moving) {
    pixels += cv::countNonZero(mask);
    all += double(mask.total());
  }
  return pixels > kMotionFraction * all;
}

bool showWhatLeftLater(const SceneSamples& first, const std::vector<cv::Mat>& later) {
  if (later.size() < kFewest) return false;
  const Scene before = sceneOf(findCandidates(first), first.size);
  const Scene after = sceneOf(candidatesOf(later, first.colors[0]), first.size);
  cv::Mat labels, stats, centers;
  const cv::Mat changed = changedPixels(before, after);
  const int n = cv::connectedComponentsWithStats(changed, labels, stats, centers);
  for (int label = 1; label < n; ++label)
    if (stats.at<int>(label, cv::CC_STAT_AREA) > kLeftFraction * first.size.area() &&
        hasLeft(labels == label, before, after) && !isOtherLight(labels == label, before, after))
      return true;
  return false;
}

}  // namespace markerless_mocap
