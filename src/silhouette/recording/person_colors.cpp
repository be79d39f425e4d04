#include "silhouette/recording/person_colors.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr int kBins = 16;          ///< per channel
constexpr float kDifference = 25;  ///< of people from the background, grey levels
constexpr double kFloor = 1e-4;    ///< of a probability
constexpr int kSampleStep = 3;     ///< every third sample is enough

int binOf(const cv::Vec3f& color) {
  int bin = 0;
  for (int c = 0; c < 3; ++c)
    bin = bin * kBins + std::clamp(int(color[c] * kBins / 256), 0, kBins - 1);
  return bin;
}

}  // namespace

PersonColors::PersonColors(const SceneSamples& samples, const SceneColors& scene,
                           const cv::Mat& swept) {
  std::vector<double> person(size_t(kBins) * kBins * kBins, 0), background = person;
  double people = 0, scenes = 0;
  for (int y = 0; y < swept.rows; ++y)
    for (int x = 0; x < swept.cols; ++x) {
      if (!scene.known.at<uint8_t>(y, x)) continue;
      const cv::Vec3f& expected = scene.color.at<cv::Vec3f>(y, x);
      background[binOf(expected)] += 1;
      scenes += 1;
      if (!swept.at<uint8_t>(y, x)) continue;
      for (int i = 0; i < samples.count(); i += kSampleStep) {
        const cv::Vec3f now = samples.colors[i].at<cv::Vec3b>(y, x);
        if (cv::norm(now - expected) < kDifference) continue;
        person[binOf(now)] += 1;
        people += 1;
      }
    }
  if (people == 0 || scenes == 0) return;
  log_ratio_.resize(person.size());
  for (size_t i = 0; i < person.size(); ++i)
    log_ratio_[i] =
        float(std::log((person[i] / people + kFloor) / (background[i] / scenes + kFloor)));
}

float PersonColors::logRatio(const cv::Vec3f& color) const {
  return log_ratio_.empty() ? 0 : log_ratio_[binOf(color)];
}

}  // namespace markerless_mocap
