#include "region/region_view.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

constexpr int kSamplesAcross = 330;  // every second pixel up to VGA, fewer of larger images

// Colours decide if a larger fraction of the body's box is unknown. The box is wider than the body
// by kNear_sigmas expected errors and kNear samples.
constexpr double kMaxUnknownNear = 0.005;
constexpr float kNear_sigmas = 2.5f, kNear = 2.f;

int stepOf(const cv::Mat& mask) {
  return std::max(1, (mask.cols + kSamplesAcross - 1) / kSamplesAcross);
}

/// The part of the image that whole samples cover.
cv::Rect sampledBox(const cv::Mat& image, int step) {
  return {0, 0, image.cols / step * step, image.rows / step * step};
}

cv::Mat sampled(const cv::Mat& image, int step, cv::InterpolationFlags how) {
  if (step == 1) return image;
  cv::Mat out;
  cv::resize(image(sampledBox(image, step)), out, {image.cols / step, image.rows / step}, 0, 0,
             how);
  return out;
}

}  // namespace

RegionView regionView(const cv::Mat& image, const cv::Mat& mask) {
  const int step = stepOf(mask);
  return {step, image.empty() ? image : sampled(image, step, cv::INTER_AREA),
          sampled(mask, step, cv::INTER_NEAREST)};
}

RegionView coarser(const RegionView& view) {
  return {2 * view.step, sampled(view.colors, 2, cv::INTER_AREA),
          sampled(view.known, 2, cv::INTER_NEAREST)};
}

bool isUnknownNear(const ProjectedBody& body, const cv::Mat& known) {
  const float reach = kNear_sigmas * body.sigma + kNear;
  cv::Rect2f box;
  for (const ProjectedCone& cone : body.cones) {
    const float x = std::min(cone.a.x() - cone.radius_a, cone.b.x() - cone.radius_b) - reach;
    const float y = std::min(cone.a.y() - cone.radius_a, cone.b.y() - cone.radius_b) - reach;
    const float right = std::max(cone.a.x() + cone.radius_a, cone.b.x() + cone.radius_b) + reach;
    const float bottom = std::max(cone.a.y() + cone.radius_a, cone.b.y() + cone.radius_b) + reach;
    const cv::Rect2f wide(x, y, right - x, bottom - y);
    box = box.area() > 0 ? box | wide : wide;
  }
  const cv::Rect near = cv::Rect(box) & cv::Rect(0, 0, known.cols, known.rows);
  return near.area() > 0 &&
         cv::countNonZero(known(near) == kUnknownPixel) > kMaxUnknownNear * near.area();
}

cv::Mat enlarged(const cv::Mat& samples, int step, const cv::Size& image) {
  if (step == 1) return samples;
  cv::Mat out = cv::Mat::zeros(image, CV_8UC1), smooth;
  const cv::Rect box = cv::boundingRect(samples);
  if (box.area() == 0) return out;
  const cv::Rect wide =
      (box + cv::Size(2, 2) - cv::Point(1, 1)) & cv::Rect(0, 0, samples.cols, samples.rows);
  cv::resize(samples(wide), smooth, wide.size() * step, 0, 0, cv::INTER_LINEAR);
  cv::Mat(smooth > 127)
      .copyTo(out(cv::Rect(wide.x * step, wide.y * step, smooth.cols, smooth.rows)));
  return out;
}

}  // namespace markerless_mocap
