#include "silhouette/background/light_gain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace markerless_mocap {
namespace {

/// Number of compared pixels; gives a precision of about 0.001.
constexpr double kSamples = 1000;
constexpr int kFewest = 50;
/// The rows of the sample grid are this many times further apart than on a square grid, its columns
/// this many times nearer.
constexpr int kRowsApart = 2;
// Dark pixels are mostly noise, bright ones are clipped.
constexpr int kDarkest = 25, kBrightest = 230;
/// An image is clipped if this fraction of its values is beyond these.
constexpr double kClippedFraction = 0.5;
constexpr int kBlack = 8, kWhite = 250;
/// Ratios further from the median belong to people and shadows.
constexpr float kInlierBand = 0.05f;

/// Precise to half a bin, which is far less than the width of the inlier band.
float median(const std::vector<float>& ratios) {
  constexpr int kBins = 1000, kBinsPerOne = 400;
  std::array<uint32_t, kBins> counts{};
  for (const float ratio : ratios) ++counts[std::min(kBins - 1, int(ratio * kBinsPerOne))];
  size_t below = 0;
  int bin = 0;
  while ((below += counts[bin]) <= ratios.size() / 2) ++bin;
  return (float(bin) + 0.5f) / kBinsPerOne;
}

/// \param expected_row gives for row y a function of (x, channel) that returns a grey level
template <class ExpectedT>
std::vector<float> brightnessRatios(const cv::Mat& image, const ExpectedT& expected_row) {
  const int channels = image.channels();
  // Few rows with many pixels each, as memory is contiguous along rows.
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

LightGain robustMeanRatio(const std::vector<float>& ratios) {
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

bool isClipped(const cv::Mat& image, double gain) {
  const bool dark = gain <= kDarkestGain, bright = gain >= kBrightestGain;
  if (!dark && !bright) return false;
  const int step = std::max(1, int(std::sqrt(image.total() / kSamples)));
  const int channels = image.channels();
  size_t all = 0, clipped = 0;
  for (int y = step / 2; y < image.rows; y += step)
    for (int x = step / 2; x < image.cols; x += step)
      for (int c = 0; c < channels; ++c, ++all) {
        const int value = image.ptr(y)[x * channels + c];
        clipped += dark ? value <= kBlack : value >= kWhite;
      }
  return double(clipped) > kClippedFraction * double(all);
}

LightGain estimateLightGain(const cv::Mat& image, const Background& expected) {
  return robustMeanRatio(brightnessRatios(image, [&](int y) {
    return [mean = expected.quantised(0, y).mean](int x, int c) { return int(mean[c][x]); };
  }));
}

LightGain estimateLightGain(const cv::Mat& image, const cv::Mat& expected) {
  const int channels = expected.channels();
  return robustMeanRatio(brightnessRatios(image, [&](int y) {
    return [=, row = expected.ptr(y)](int x, int c) { return int(row[x * channels + c]); };
  }));
}

}  // namespace markerless_mocap
