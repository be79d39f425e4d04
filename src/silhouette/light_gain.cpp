#include "silhouette/light_gain.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace markerless_mocap {
namespace {

constexpr int kGridStep = 7;
// Dark pixels are mostly noise, bright ones clip.
constexpr float kDarkest = 25, kBrightest = 230;
/// Ratios further from the first estimate are people and shadows.
constexpr float kInlierBand = 0.1f;

float median(std::vector<float>* values) {
  const auto middle = values->begin() + values->size() / 2;
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

std::vector<float> brightnessRatios(const cv::Mat& image, const cv::Mat& mean) {
  const int channels = image.channels();
  std::vector<float> ratios;
  for (int y = kGridStep / 2; y < image.rows; y += kGridStep)
    for (int x = kGridStep / 2; x < image.cols; x += kGridStep) {
      const uint8_t* now = image.ptr<uint8_t>(y) + size_t(x) * channels;
      const float* usual = mean.ptr<float>(y) + size_t(x) * channels;
      float sum_now = 0, sum_usual = 0;
      bool reliable = true;
      for (int c = 0; c < channels; ++c) {
        reliable = reliable && usual[c] >= kDarkest && usual[c] <= kBrightest;
        sum_now += now[c];
        sum_usual += usual[c];
      }
      if (reliable) ratios.push_back(sum_now / sum_usual);
    }
  return ratios;
}

}  // namespace

double estimateLightGain(const cv::Mat& image, const cv::Mat& mean) {
  constexpr size_t kFewest = 50;
  std::vector<float> ratios = brightnessRatios(image, mean);
  if (ratios.size() < kFewest) return 1;
  const float first = median(&ratios);
  const auto far = [first](float r) { return std::abs(r - first) > kInlierBand * first; };
  ratios.erase(std::remove_if(ratios.begin(), ratios.end(), far), ratios.end());
  return std::clamp<double>(median(&ratios), 0.5, 2.0);
}

}  // namespace markerless_mocap
