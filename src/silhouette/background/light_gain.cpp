#include "silhouette/background/light_gain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace markerless_mocap {
namespace {

/// Compared pixels; enough for a thousandth.
constexpr double kSamples = 1000;
constexpr int kFewest = 50;
/// So many times further apart than on a square grid are its rows, and nearer its columns.
constexpr int kRowsApart = 2;
// Dark pixels are mostly noise, bright ones clip.
constexpr int kDarkest = 25, kBrightest = 230;
/// Ratios further from the median are people and shadows.
constexpr float kInlierBand = 0.05f;

/// To half a bin, which is far less than the band of the inliers.
float median(const std::vector<float>& ratios) {
  constexpr int kBins = 1000, kBinsPerOne = 400;
  std::array<uint32_t, kBins> counts{};
  for (const float ratio : ratios) ++counts[std::min(kBins - 1, int(ratio * kBinsPerOne))];
  size_t below = 0;
  int bin = 0;
  while ((below += counts[bin]) <= ratios.size() / 2) ++bin;
  return (float(bin) + 0.5f) / kBinsPerOne;
}

/// \param expected_row what gives row y's grey level of (x, channel)
template <class UsualT>
std::vector<float> brightnessRatios(const cv::Mat& image, const UsualT& expected_row) {
  const int channels = image.channels();
  // Few rows of many pixels: memory comes in rows.
  const int step = std::max(2, int(std::sqrt(image.total() / kSamples) / kRowsApart));
  const int row_step = step * kRowsApart * kRowsApart;
  std::vector<float> ratios;
  ratios.reserve(size_t(image.cols / step + 1) * (image.rows / row_step + 1));
  for (int y = row_step / 2; y < image.rows; y += row_step) {
    const auto expected_at = expected_row(y);
    for (int x = step / 2; x < image.cols; x += step) {
      const uint8_t* now = image.ptr(y) + size_t(x) * channels;
      int sum_now = 0, sum_expected = 0;
      bool reliable = true;
      for (int c = 0; c < channels; ++c) {
        const int expected = expected_at(x, c);
        reliable = reliable & (expected >= kDarkest) & (expected <= kBrightest);
        sum_now += now[c];
        sum_expected += expected;
      }
      if (reliable) ratios.push_back(float(sum_now) / float(sum_expected));
    }
  }
  return ratios;
}

LightGain mostUsual(const std::vector<float>& ratios) {
  LightGain result;
  if (ratios.size() < kFewest) return result;
  const float middle = median(ratios);
  double sum = 0;
  size_t near = 0;
  for (const float ratio : ratios) {
    if (std::abs(ratio - middle) > kInlierBand * middle) continue;
    sum += ratio;
    ++near;
  }
  result.gain = std::clamp(sum / near, kDarkestGain, kBrightestGain);
  result.inlier_fraction = double(near) / ratios.size();
  return result;
}

}  // namespace

LightGain estimateLightGain(const cv::Mat& image, const Background& expected) {
  return mostUsual(brightnessRatios(image, [&](int y) {
    return [mean = expected.coarse(0, y).mean](int x, int c) { return int(mean[c][x]); };
  }));
}

LightGain estimateLightGain(const cv::Mat& image, const cv::Mat& expected) {
  const int channels = expected.channels();
  return mostUsual(brightnessRatios(image, [&](int y) {
    return [=, row = expected.ptr(y)](int x, int c) { return int(row[x * channels + c]); };
  }));
}

}  // namespace markerless_mocap
