#include "checks/pictures/light_gain_track.h"

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMostForMedian = 150;
constexpr int kDark = 12, kBright = 245;  // levels that say nothing of a gain

using Pixels = std::vector<const cv::Mat*>;

/// Median over time of each value of the pictures.
cv::Mat usualColors(const Pixels& pictures) {
  cv::Mat usual(pictures.front()->size(), CV_8UC3);
  const size_t step = pictures.size() / kMostForMedian + 1;
  const size_t values = usual.total() * 3;
  std::vector<uint8_t> column;
  for (size_t v = 0; v < values; ++v) {
    column.clear();
    for (size_t i = 0; i < pictures.size(); i += step) column.push_back(pictures[i]->data[v]);
    usual.data[v] = medianAmong(column);
  }
  return usual;
}

std::array<double, 3> gainOf(const cv::Mat& picture, const cv::Mat& usual) {
  std::array<double, 3> gain;
  std::vector<double> ratios;
  for (size_t channel = 0; channel < 3; ++channel) {
    ratios.clear();
    for (size_t v = channel; v < usual.total() * 3; v += 3)
      if (usual.data[v] > kDark && usual.data[v] < kBright)
        ratios.push_back(double(picture.data[v]) / usual.data[v]);
    gain[channel] = ratios.size() < 20 ? 1.0 : nearestQuantile(ratios, 0.5);
  }
  return gain;
}

}  // namespace

LightTrack lightTrackOf(const std::vector<SeenImage>& images) {
  LightTrack track;
  Pixels pictures;
  for (const SeenImage& image : images) {
    const bool fits = !image.colors.empty() && image.colors.isContinuous() &&
                      (pictures.empty() || image.colors.size() == pictures.front()->size());
    if (!fits) continue;
    pictures.push_back(&image.colors);
    track.seconds.push_back(1e-9 * double(image.received_ns - images.front().received_ns));
  }
  if (pictures.empty()) return track;
  const cv::Mat usual = usualColors(pictures);
  for (const cv::Mat* picture : pictures) track.gains.push_back(gainOf(*picture, usual));
  return track;
}

}  // namespace markerless_mocap
