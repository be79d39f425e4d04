#include "capture/degradations/mask_damage.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "numerics/split_mix.h"

namespace markerless_mocap {
namespace {

/// A sequence of random numbers.
class RandomStream {
 public:
  explicit RandomStream(uint64_t stream) : state_(splitMix64(stream)) {}
  double uniform(double low, double high) { return low + (high - low) * splitMixUniform(state_++); }
  int below(int count) { return int(uniform(0.0, count)); }

 private:
  uint64_t state_;
};

/// Shifts the outline inward or outward by smooth noise of up to `reach` pixels.
cv::Mat ragged(const cv::Mat& mask, double reach, RandomStream& rng) {
  constexpr int kCell = 6;  // pixels; size of the irregularities
  cv::Mat noise(mask.rows / kCell + 2, mask.cols / kCell + 2, CV_32FC1);
  for (int y = 0; y < noise.rows; ++y)
    for (int x = 0; x < noise.cols; ++x) noise.at<float>(y, x) = float(rng.uniform(-1.0, 1.0));
  cv::Mat shift;
  cv::resize(noise, shift, mask.size(), 0, 0, cv::INTER_CUBIC);
  cv::Mat inside, outside;
  cv::distanceTransform(mask, inside, cv::DIST_L2, 3);
  cv::distanceTransform(~mask, outside, cv::DIST_L2, 3);
  return inside - outside > shift * reach;
}

/// Draws a random blob of a few ellipses around a point.
void stamp(cv::Mat& mask, cv::Point place, double radius, uint8_t value, RandomStream& rng) {
  for (int i = 0; i < 3; ++i) {
    const cv::Point at = place + cv::Point(int(std::lround(rng.uniform(-radius, radius))),
                                           int(std::lround(rng.uniform(-radius, radius))));
    const cv::Size axes(int(std::ceil(rng.uniform(0.3, 1.0) * radius)),
                        int(std::ceil(rng.uniform(0.3, 1.0) * radius)));
    cv::ellipse(mask, at, axes, rng.uniform(0.0, 180.0), 0.0, 360.0, cv::Scalar(value), cv::FILLED);
  }
}

}  // namespace

cv::Mat damagedMask(const cv::Mat& mask, double amount, uint64_t stream) {
  if (!(amount >= 0.0 && amount <= 1.0))
    throw std::invalid_argument("the masks' damage is " + std::to_string(amount) +
                                ", allowed is 0 to 1");
  if (amount == 0.0) return mask.clone();
  RandomStream rng(stream);
  const double scale = mask.rows / 480.0;
  cv::Mat damaged = ragged(mask, 4.0 * amount * scale, rng);
  std::vector<cv::Point> person;
  cv::findNonZero(mask, person);
  const int holes = person.empty() ? 0 : int(std::lround(amount * rng.uniform(4.0, 16.0)));
  for (int i = 0; i < holes; ++i)
    stamp(damaged, person[size_t(rng.below(int(person.size())))],
          scale * rng.uniform(1.5, 3.0 + 6.0 * amount), 0, rng);
  const int specks = int(std::lround(amount * rng.uniform(20.0, 80.0)));
  for (int i = 0; i < specks; ++i)
    stamp(damaged, {rng.below(mask.cols), rng.below(mask.rows)}, scale * rng.uniform(0.5, 2.5), 255,
          rng);
  return damaged;
}

}  // namespace markerless_mocap
