#include "region/colors/color_bins.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

// Range of a and b in OpenCV's 8 bit Lab (neutral at 128) that the chroma bins cover.
constexpr int kChromaLow = 88, kChromaHigh = 168;

int chromaBin(int value) {
  return std::clamp((value - kChromaLow) * ColorBins::kChroma / (kChromaHigh - kChromaLow), 0,
                    ColorBins::kChroma - 1);
}

}  // namespace

ColorBins::ColorBins() {
  constexpr int kLevels = 1 << kBits;
  cv::Mat bgr(1, int(bin_.size()), CV_8UC3), lab;
  for (int i = 0; i < bgr.cols; ++i) {
    const auto level = [](int index) { return uchar((index % kLevels) * 255 / (kLevels - 1)); };
    bgr.at<cv::Vec3b>(0, i) = {level(i >> (2 * kBits)), level(i >> kBits), level(i)};
  }
  cv::cvtColor(bgr, lab, cv::COLOR_BGR2Lab);
  for (int i = 0; i < bgr.cols; ++i) {
    const cv::Vec3b color = lab.at<cv::Vec3b>(0, i);
    const int lightness = color[0] * kLightness / 256;
    bin_[size_t(i)] =
        uint16_t((lightness * kChroma + chromaBin(color[1])) * kChroma + chromaBin(color[2]));
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
