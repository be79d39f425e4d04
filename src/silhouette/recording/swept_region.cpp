#include "silhouette/recording/swept_region.h"

#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

constexpr float kDeviation = 16;  ///< grey levels
constexpr int kMinSamples = 2;
constexpr int kClose = 9, kDilate = 7, kOpen = 3;
constexpr int kMinArea = 60;

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
      for (const cv::Mat& color : samples.colors)
        count += cv::norm(cv::Vec3f(color.at<cv::Vec3b>(y, x)) - mode) > kDeviation;
      different.at<uint8_t>(y, x) = count >= kMinSamples ? 255 : 0;
    }
  return different;
}

}  // namespace

cv::Mat sweptRegion(const SceneSamples& samples, const std::vector<PixelCandidates>& candidates) {
  cv::Mat different = oftenDifferent(samples, candidates);
  cv::morphologyEx(different, different, cv::MORPH_OPEN, ellipse(kOpen));
  cv::morphologyEx(different, different, cv::MORPH_CLOSE, ellipse(kClose));
  cv::Mat swept = different.clone();
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(different, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  for (const std::vector<cv::Point>& outline : outlines) {
    if (cv::contourArea(outline) < kMinArea) continue;
    std::vector<cv::Point> hull;
    cv::convexHull(outline, hull);
    cv::fillConvexPoly(swept, hull, cv::Scalar(255));
  }
  cv::dilate(swept, swept, ellipse(kDilate));
  return swept;
}

}  // namespace markerless_mocap
