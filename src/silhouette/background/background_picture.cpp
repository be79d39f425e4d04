#include "markerless_mocap/silhouette/background_picture.h"

#include <opencv2/imgproc.hpp>

#include "silhouette/background/background.h"

namespace markerless_mocap {
namespace {

uint8_t greyLevel(uint16_t mean) {
  return cv::saturate_cast<uint8_t>(mean / double(Background::kMeanScale));
}

}  // namespace

BackgroundPicture pictureOf(const Background& background) {
  const int channels = background.channels();
  cv::Mat colors(background.size(), background.type());
  for (int y = 0; y < colors.rows; ++y)
    for (int c = 0; c < channels; ++c) {
      const uint16_t* means = background.mean(0, y, c);
      uint8_t* row = colors.ptr<uint8_t>(y) + c;
      for (int x = 0; x < colors.cols; ++x, row += channels) *row = greyLevel(means[x]);
    }
  if (channels == 1) cv::cvtColor(colors, colors, cv::COLOR_GRAY2BGR);
  cv::Mat unknown = cv::Mat::zeros(background.size(), CV_8UC1);
  if (background.hasUnknown()) unknown = background.unknown().toMat();
  return {colors, unknown};
}

}  // namespace markerless_mocap
