#include "silhouette/recording/first_images.h"

#include <opencv2/imgproc.hpp>

#include "silhouette/background/light_gain.h"
#include "silhouette/recording/color_candidates.h"

namespace markerless_mocap {
namespace {

/// Mean fraction of the image in which something moves. Empty rooms have 0, the least that a person
/// had in twelve views is 0.055.
constexpr double kMotionFraction = 0.005;
/// Fraction of the image of the largest region that has changed.
constexpr double kLeftFraction = 0.002;
constexpr float kChange = 25;           ///< grey levels
constexpr float kConstantShare = 0.8f;  ///< of the later images
constexpr size_t kFewest = 4;           ///< later images to decide by
constexpr int kOpen = 3;
// Around what has left, at most some pixels of the later images are not constant.
constexpr int kAround = 7;  ///< pixels
constexpr double kQuietAround = 0.8;

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

/// True if there is a large region of `changed` that nothing moves around.
bool hasQuietRegion(const cv::Mat& changed, const cv::Mat& constant) {
  cv::Mat labels, stats, centers;
  const int n = cv::connectedComponentsWithStats(changed, labels, stats, centers);
  const cv::Mat element =
      cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * kAround + 1, 2 * kAround + 1});
  for (int label = 1; label < n; ++label) {
    if (stats.at<int>(label, cv::CC_STAT_AREA) <= kLeftFraction * double(changed.total())) continue;
    const cv::Mat region = labels == label;
    cv::Mat around;
    cv::dilate(region, around, element);
    around.setTo(0, region);
    const int quiet = cv::countNonZero(around & constant);
    if (quiet > kQuietAround * cv::countNonZero(around)) return true;
  }
  return false;
}

}  // namespace

bool showMotion(const SceneSamples& samples) {
  double moving = 0;
  for (const cv::Mat& mask : samples.moving) moving += cv::countNonZero(mask);
  return moving > kMotionFraction * samples.size.area() * samples.count();
}

bool showWhatLeftLater(const SceneSamples& first, const std::vector<cv::Mat>& later) {
  if (later.size() < kFewest) return false;
  const std::vector<PixelCandidates> before = findCandidates(first);
  const std::vector<PixelCandidates> after = candidatesOf(later, first.colors[0]);
  cv::Mat changed(first.size, CV_8UC1), constant(first.size, CV_8UC1);
  for (size_t i = 0; i < before.size(); ++i) {
    const ColorCandidate& now = after[i].colors[0];
    const bool differs = cv::norm(now.color - before[i].colors[0].color) > kChange;
    constant.data[i] = now.share >= kConstantShare ? 255 : 0;
    changed.data[i] = differs ? constant.data[i] : 0;
  }
  const cv::Mat element = cv::getStructuringElement(cv::MORPH_ELLIPSE, {kOpen, kOpen});
  cv::morphologyEx(changed, changed, cv::MORPH_OPEN, element);
  return hasQuietRegion(changed, constant);
}

}  // namespace markerless_mocap
