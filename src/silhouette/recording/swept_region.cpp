#include "silhouette/recording/swept_region.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

constexpr float kDeviation = 16;  ///< grey levels
constexpr int kMinSamples = 2;
constexpr int kClose = 9, kDilate = 7, kOpen = 3;
constexpr int kMinArea = 60;

// How far a person may reach beside and below a part that moves, by its shorter and its longer
// side: a forearm that waves is a fifth of their height, and the legs are below.
constexpr float kBesideSides = 2.5f, kBelowSides = 4.f;
// With it they are not wider and taller than these fractions of the image's height.
constexpr float kWidest = 0.3f, kTallest = 0.75f;
// At the border of the image, this fraction of its size is left to continue from.
constexpr int kBorderFraction = 16;
constexpr float kStays = 0.6f;  ///< fraction of the samples with motion

cv::Mat ellipse(int side) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {side, side});
}

cv::Mat oftenDifferent(const SceneSamples& samples,
                       const std::vector<PixelCandidates>& candidates) {
  cv::Mat different(samples.size, CV_8UC1);
  for (int y = 0; y < different.rows; ++y)
    for (int x = 0; x < different.cols; ++x) {
      const cv::Vec3f& mode = candidates[size_t(y) * different.cols + x].colors[0].color;
      int count = 0;
      for (const cv::Mat& color : samples.colors) {
        const cv::Vec3f off = cv::Vec3f(color.at<cv::Vec3b>(y, x)) - mode;
        count += off.dot(off) > kDeviation * kDeviation;
      }
      different.at<uint8_t>(y, x) = count >= kMinSamples ? 255 : 0;
    }
  return different;
}

/// The bounding box, larger by a quarter of its longer side.
cv::Rect surroundings(const std::vector<cv::Point>& region) {
  const cv::Rect box = cv::boundingRect(region);
  const int margin = std::max(box.width, box.height) / 4;
  return {box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin};
}

/// Joins two regions that are near each other; returns whether there were any.
bool joinTwo(std::vector<std::vector<cv::Point>>* regions) {
  for (size_t i = 0; i < regions->size(); ++i)
    for (size_t j = i + 1; j < regions->size(); ++j) {
      std::vector<cv::Point>&first = (*regions)[i], &second = (*regions)[j];
      if ((surroundings(first) & surroundings(second)).empty()) continue;
      first.insert(first.end(), second.begin(), second.end());
      regions->erase(regions->begin() + ptrdiff_t(j));
      return true;
    }
  return false;
}

std::vector<std::vector<cv::Point>> largeRegions(const cv::Mat& mask) {
  std::vector<std::vector<cv::Point>> regions;
  cv::findContours(mask, regions, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  const auto is_small = [](const std::vector<cv::Point>& region) {
    return cv::contourArea(region) < kMinArea;
  };
  regions.erase(std::remove_if(regions.begin(), regions.end(), is_small), regions.end());
  return regions;
}

/// The two sides of a person who sways are one region: between them, the person is always there.
std::vector<std::vector<cv::Point>> joinedRegions(const cv::Mat& mask) {
  std::vector<std::vector<cv::Point>> regions = largeRegions(mask);
  while (joinTwo(&regions)) {
  }
  return regions;
}

/// The rectangles that a person has at most of whom a part moves.
cv::Mat aroundPartsThatMove(const cv::Mat& moving) {
  cv::Mat around = cv::Mat::zeros(moving.size(), CV_8UC1);
  const int border = std::max(moving.cols, moving.rows) / kBorderFraction;
  const cv::Rect inside(border, border, moving.cols - 2 * border, moving.rows - 2 * border);
  for (const std::vector<cv::Point>& region : largeRegions(moving)) {
    const cv::Rect box = cv::boundingRect(region);
    const float rows = float(moving.rows), width = float(box.width), height = float(box.height);
    const int beside = int(
                  std::clamp(kWidest * rows - width, 0.f, kBesideSides * std::min(width, height))),
              below = int(
                  std::clamp(kTallest * rows - height, 0.f, kBelowSides * std::max(width, height)));
    const cv::Point first(box.x - beside, box.y), last(box.br().x + beside, box.br().y + below);
    around(cv::Rect(first, last) & inside).setTo(1);
  }
  return around;
}

/// Where a person may stand who stays, and moves the arms alone: parts that never move have the
/// colour of the background as far as differences tell.
cv::Mat aroundWhoStays(const SceneSamples& samples) {
  cv::Mat count = cv::Mat::zeros(samples.size, CV_8UC1);
  int with_motion = 0;
  for (const cv::Mat& moving : samples.moving) {
    const cv::Mat around = aroundPartsThatMove(moving);
    count += around;
    with_motion += cv::countNonZero(around) > 0;
  }
  return (count >= std::max(double(kMinSamples), std::ceil(double(kStays) * with_motion)));
}

}  // namespace

SweptRegion sweptRegion(const SceneSamples& samples,
                        const std::vector<PixelCandidates>& candidates) {
  cv::Mat different = oftenDifferent(samples, candidates);
  cv::morphologyEx(different, different, cv::MORPH_OPEN, ellipse(kOpen));
  cv::morphologyEx(different, different, cv::MORPH_CLOSE, ellipse(kClose));
  SweptRegion swept{different.clone(), {}};
  for (const std::vector<cv::Point>& region : joinedRegions(different)) {
    std::vector<cv::Point> hull;
    cv::convexHull(region, hull);
    cv::fillConvexPoly(swept.seen, hull, cv::Scalar(255));
  }
  cv::dilate(swept.seen, swept.seen, ellipse(kDilate));
  swept.all = swept.seen | aroundWhoStays(samples);
  return swept;
}

}  // namespace markerless_mocap
