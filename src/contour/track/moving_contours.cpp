#include "contour/track/moving_contours.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "contour/track/search_times.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr int kSamplesAcross = 165;
constexpr int64_t kInterval_ns = 200000000;  // between two frames that are compared
constexpr int kFirstFrames = 5;              // the first ones are compared without interval
constexpr double kMemory_s = 2.0;

// A sample moves if its temporal deviation is above this factor of the median over the image, and
// above this number of grey levels. A contour moves if a sample near it does.
constexpr double kMovingFactor = 4.0, kMinMoving = 1.0;
constexpr int kNear = 1;  // samples

constexpr double kMinLiving = 0.1;  // fraction of the rays

cv::Mat brightnessOf(const cv::Mat& image, int step) {
  cv::Mat small, grey;
  // The mean of four pixels; that of all would take longer.
  cv::resize(image, small, {(image.cols - 1) / step + 1, (image.rows - 1) / step + 1}, 0, 0,
             cv::INTER_LINEAR);
  if (small.channels() == 3)
    cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
  else
    grey = small;
  cv::GaussianBlur(grey, grey, {3, 3}, 0);
  cv::Mat out;
  grey.convertTo(out, CV_32F);
  return out;
}

float medianOfMost(const cv::Mat& values) {
  std::vector<float> some;
  for (int y = 0; y < values.rows; y += 4)
    for (int x = 0; x < values.cols; x += 4) some.push_back(values.at<float>(y, x));
  return medianAmong(some);
}

}  // namespace

void MovingContours::add(int64_t stamp_ns, const cv::Mat& image, View& view) {
  if (view.frames > kFirstFrames && stamp_ns < nextInstant(view.last_ns, kInterval_ns)) return;
  view.step = std::max(1, (image.cols + kSamplesAcross - 1) / kSamplesAcross);
  const cv::Mat now = brightnessOf(image, view.step);
  if (view.frames == 0 || view.mean.size() != now.size()) {
    view.mean = now;
    view.variance = cv::Mat::zeros(now.size(), CV_32F);
    view.frames = 1;
    view.last_ns = stamp_ns;
    return;
  }
  const double rate = std::max(1.0 / ++view.frames,
                               std::min(1.0, 1e-9 * double(stamp_ns - view.last_ns) / kMemory_s));
  view.last_ns = stamp_ns;
  const cv::Mat off = now - view.mean;
  view.mean += rate * off;
  view.variance = (1.0 - rate) * (view.variance + rate * off.mul(off));
  const double deviation =
      std::max(kMinMoving, kMovingFactor * std::sqrt(double(medianOfMost(view.variance))));
  const cv::Mat moving = view.variance >= deviation * deviation;
  cv::dilate(moving, view.moving, cv::Mat::ones(2 * kNear + 1, 2 * kNear + 1, CV_8U));
}

void MovingContours::watch(int64_t stamp_ns, const std::vector<cv::Mat>& images,
                           const std::vector<cv::Mat>& masks) {
  tbb::parallel_for(size_t(0), views_.size(), [&](size_t i) {
    const bool has_image = i < images.size() && !images[i].empty();
    const cv::Mat image = has_image ? images[i] : masks[i];
    if (image.empty()) return;
    // An image and a mask differ everywhere, which is no movement.
    if (views_[i].shows_images != has_image) views_[i] = {};
    views_[i].shows_images = has_image;
    add(stamp_ns, image, views_[i]);
  });
}

bool MovingContours::moves(const ContourRay& ray) const {
  const View& view = views_[size_t(ray.camera)];
  if (view.moving.empty()) return false;
  const int x = std::clamp(int(ray.pixel.x()) / view.step, 0, view.moving.cols - 1);
  const int y = std::clamp(int(ray.pixel.y()) / view.step, 0, view.moving.rows - 1);
  return view.moving.at<uchar>(y, x);
}

bool MovingContours::showLife(const ContourObservation& seen) const {
  const auto living = std::count_if(seen.rays.begin(), seen.rays.end(),
                                    [&](const ContourRay& ray) { return moves(ray); });
  return double(living) > kMinLiving * double(seen.rays.size());
}

}  // namespace markerless_mocap
