#include "silhouette/recording/swept_region.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

constexpr float kDeviation = 16;  ///< grey levels
constexpr int kMinSamples = 2;
constexpr int kClose = 9, kDilate = 7, kOpen = 3;
constexpr int kMinArea = 60;
constexpr float kNoiseFactor = 1.5f;
constexpr int kBins = 16;  ///< of brightness

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

int binOf(const PixelCandidates& pixel) {
  const cv::Vec3f& color = pixel.colors[0].color;
  return std::clamp(int((color[0] + color[1] + color[2]) / 3 * kBins / 256), 0, kBins - 1);
}

/// Median deviation of the pixels outside of `swept`, by brightness.
std::array<float, kBins> noiseByBrightness(const std::vector<PixelCandidates>& candidates,
                                           const cv::Mat& swept) {
  std::array<std::vector<float>, kBins> deviations;
  std::vector<float> all = {1};
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (swept.data[i]) continue;
    deviations[binOf(candidates[i])].push_back(candidates[i].deviation);
    all.push_back(candidates[i].deviation);
  }
  const auto median = [](std::vector<float>& values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
  };
  std::array<float, kBins> noise;
  constexpr size_t kEnough = 50;
  const float overall = median(all);
  for (int i = 0; i < kBins; ++i)
    noise[i] = deviations[i].size() < kEnough ? overall : median(deviations[i]);
  return noise;
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

cv::Mat stillPixels(const std::vector<PixelCandidates>& candidates, const cv::Mat& swept) {
  const std::array<float, kBins> noise = noiseByBrightness(candidates, swept);
  cv::Mat still(swept.size(), CV_8UC1);
  for (size_t i = 0; i < candidates.size(); ++i)
    still.data[i] = candidates[i].deviation < kNoiseFactor * noise[binOf(candidates[i])] ? 255 : 0;
  cv::morphologyEx(still, still, cv::MORPH_OPEN, ellipse(kOpen));
  return still;
}

}  // namespace markerless_mocap
