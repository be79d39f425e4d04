#include "capture/degradations/auto_camera.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

constexpr int kStep = 3;  // one pixel in this many along both axes is metered

double brightnessOf(const cv::Scalar& color) {
  return (color[0] + color[1] + color[2]) / 3.0;
}

}  // namespace

cv::Scalar meteredColor(const cv::Mat& image) {
  constexpr double kSpread = 0.25;  // fraction of the image's size
  const auto weightAt = [](int at, int size) {
    const double off = (at - 0.5 * (size - 1)) / (kSpread * size);
    return std::exp(-0.5 * off * off);
  };
  cv::Scalar sum;
  double weights = 0.0;
  for (int y = 0; y < image.rows; y += kStep)
    for (int x = 0; x < image.cols; x += kStep) {
      const double weight = weightAt(x, image.cols) * weightAt(y, image.rows);
      const cv::Vec3b& color = image.at<cv::Vec3b>(y, x);
      sum += weight * cv::Scalar(color[0], color[1], color[2]);
      weights += weight;
    }
  return sum / weights;
}

void followLight(double exposure, double white_balance, const cv::Scalar& usual, cv::Mat& image) {
  if (exposure == 0.0 && white_balance == 0.0) return;
  constexpr double kDarkest = 1.0;  // grey levels
  cv::Scalar now = meteredColor(image);
  for (int i = 0; i < 3; ++i) now[i] = std::max(now[i], kDarkest);
  const double brighter = brightnessOf(usual) / brightnessOf(now);
  cv::Scalar gain;
  for (int i = 0; i < 3; ++i)
    gain[i] = std::pow(brighter, exposure) * std::pow(usual[i] / now[i] / brighter, white_balance);
  cv::multiply(image, gain, image);
}

}  // namespace markerless_mocap
