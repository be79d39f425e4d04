#include "region/colors/color_bins.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

// Range of a and b in OpenCV's 8 bit Lab (neutral at 128) that the chroma bins cover.
constexpr int kChromaLow = 88, kChromaHigh = 168;

int chromaBin(int value) {
  return std::clamp((value - kChromaLow) * ColorBins::kChroma / (kChromaHigh - kChromaLow), 0,
                    ColorBins::kChroma - 1);
}

/// The light that a level of an sRGB image stands for, 0 to 1 (IEC 61966-2-1).
double linear(uchar level) {
  const double value = level / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The function f of CIE 15, CIELAB.
double compressed(double ratio) {
  constexpr double kDelta = 6.0 / 29.0;
  return ratio > kDelta * kDelta * kDelta ? std::cbrt(ratio)
                                          : ratio / (3 * kDelta * kDelta) + 4.0 / 29.0;
}

}  // namespace

// cv::cvtColor() takes 0.15 s to begin with, for tables of a million colours.
cv::Vec3b labFromBgr(const cv::Vec3b& bgr) {
  const cv::Matx33d kToXyz(0.412453, 0.357580, 0.180423,  // of sRGB and its white, D65
                           0.212671, 0.715160, 0.072169,  //
                           0.019334, 0.119193, 0.950227);
  const cv::Vec3d kWhite(0.950456, 1.0, 1.088754);
  const cv::Vec3d xyz = kToXyz * cv::Vec3d(linear(bgr[2]), linear(bgr[1]), linear(bgr[0]));
  const double x = compressed(xyz[0] / kWhite[0]), y = compressed(xyz[1] / kWhite[1]),
               z = compressed(xyz[2] / kWhite[2]);
  return {cv::saturate_cast<uchar>((116 * y - 16) * 255 / 100),
          cv::saturate_cast<uchar>(500 * (x - y) + 128),
          cv::saturate_cast<uchar>(200 * (y - z) + 128)};
}

ColorBins::ColorBins() {
  constexpr int kLevels = 1 << kBits;
  const auto level = [](size_t index) { return uchar((index % kLevels) * 255 / (kLevels - 1)); };
  for (size_t i = 0; i < bin_.size(); ++i) {
    const cv::Vec3b color = labFromBgr({level(i >> (2 * kBits)), level(i >> kBits), level(i)});
    const int lightness = color[0] * kLightness / 256;
    bin_[i] = uint16_t((lightness * kChroma + chromaBin(color[1])) * kChroma + chromaBin(color[2]));
  }
}

const ColorBins& ColorBins::instance() {
  static const ColorBins bins;
  return bins;
}

cv::Mat ColorBins::of(const cv::Mat& bgr) const {
  cv::Mat out(bgr.size(), CV_16UC1);
  constexpr int kDrop = 8 - kBits;
  for (int y = 0; y < bgr.rows; ++y) {
    const cv::Vec3b* from = bgr.ptr<cv::Vec3b>(y);
    uint16_t* to = out.ptr<uint16_t>(y);
    for (int x = 0; x < bgr.cols; ++x)
      to[x] = bin_[size_t(from[x][0] >> kDrop) << (2 * kBits) |
                   size_t(from[x][1] >> kDrop) << kBits | size_t(from[x][2] >> kDrop)];
  }
  return out;
}

}  // namespace markerless_mocap
