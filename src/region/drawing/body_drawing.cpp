#include "region/body_drawing.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

// Distances outside the margin of all parts.
constexpr float kFar = 1e4f;

cv::Rect boxOf(const ProjectedCone& cone, float margin, const cv::Size& size) {
  const Eigen::Array2f low =
      (cone.a.array() - cone.radius_a).min(cone.b.array() - cone.radius_b) - margin;
  const Eigen::Array2f high =
      (cone.a.array() + cone.radius_a).max(cone.b.array() + cone.radius_b) + margin;
  if (!low.isFinite().all() || !high.isFinite().all()) return {};
  const auto clamped = [](float value, int end) {
    return int(std::clamp(std::floor(value), 0.f, float(end)));
  };
  const cv::Point from(clamped(low.x(), size.width), clamped(low.y(), size.height));
  const cv::Point to(clamped(high.x() + 1, size.width), clamped(high.y() + 1, size.height));
  return {from, to};
}

/// Distance to the convex hull of two disks. Along the axis a point is nearest to one of the disks
/// or to the tangent between them.
class ConeDistance {
 public:
  explicit ConeDistance(const ProjectedCone& cone)
      : a_(cone.a), radius_a_(cone.radius_a), radius_b_(cone.radius_b) {
    const Eigen::Vector2f way = cone.b - cone.a;
    length_ = way.norm();
    sine_ = length_ > 0 ? (radius_a_ - radius_b_) / length_ : 2.f;
    along_ = length_ > 0 ? Eigen::Vector2f(way / length_) : Eigen::Vector2f::UnitX();
    is_disk_ = std::abs(sine_) >= 1;  // one disk contains the other
    cosine_ = is_disk_ ? 0.f : std::sqrt(1 - sine_ * sine_);
    if (is_disk_ && radius_b_ > radius_a_) {
      a_ = cone.b;
      radius_a_ = radius_b_;
    }
  }
  float operator()(float x, float y) const {
    const float dx = x - a_.x(), dy = y - a_.y();
    const float v = along_.x() * dx + along_.y() * dy;
    const float u = std::abs(along_.x() * dy - along_.y() * dx);
    if (is_disk_) return std::sqrt(u * u + v * v) - radius_a_;
    const float k = cosine_ * v - sine_ * u;
    if (k < 0) return std::sqrt(u * u + v * v) - radius_a_;
    if (k > cosine_ * length_) return std::sqrt(u * u + (v - length_) * (v - length_)) - radius_b_;
    return cosine_ * u + sine_ * v - radius_a_;
  }

 private:
  Eigen::Vector2f a_, along_;
  float radius_a_, radius_b_, length_, sine_, cosine_;
  bool is_disk_;
};

void grow(const cv::Rect& box, cv::Rect& all) {
  if (box.area() > 0) all = all.area() > 0 ? (all | box) : box;
}

void drawCone(const ProjectedCone& cone, const cv::Rect& box, BodyDrawing& drawing,
              cv::Mat& depth) {
  const ConeDistance distance(cone);
  PartDistance& part = drawing.parts[size_t(cone.part)];
  const float front = std::min(cone.depth_a, cone.depth_b);
  for (int y = box.y; y < box.br().y; ++y) {
    float* own = part.distance.ptr<float>(y - part.box.y) - part.box.x;
    float* nearest = drawing.distance.ptr<float>(y - drawing.box.y) - drawing.box.x;
    uchar* label = drawing.part.ptr<uchar>(y - drawing.box.y) - drawing.box.x;
    float* z = depth.ptr<float>(y - drawing.box.y) - drawing.box.x;
    for (int x = box.x; x < box.br().x; ++x) {
      const float d = distance(float(x), float(y));
      own[x] = std::min(own[x], d);
      nearest[x] = std::min(nearest[x], d);
      part.depth_inside = std::max(part.depth_inside, -d);
      if (d <= 0 && front < z[x]) {
        z[x] = front;
        label[x] = uchar(cone.part);
      }
    }
  }
}

}  // namespace

BodyDrawing drawBody(const ProjectedBody& body, int parts, const cv::Size& size, float margin) {
  BodyDrawing drawing;
  drawing.parts.resize(size_t(parts));
  for (const ProjectedCone& cone : body.cones) {
    grow(boxOf(cone, margin, size), drawing.parts[size_t(cone.part)].box);
    grow(boxOf(cone, margin, size), drawing.box);
  }
  for (PartDistance& part : drawing.parts)
    part.distance = cv::Mat(part.box.size(), CV_32FC1, cv::Scalar(kFar));
  drawing.part = cv::Mat(drawing.box.size(), CV_8UC1, cv::Scalar(BodyDrawing::kNoPart));
  drawing.distance = cv::Mat(drawing.box.size(), CV_32FC1, cv::Scalar(kFar));
  cv::Mat depth(drawing.box.size(), CV_32FC1, cv::Scalar(kFar));
  for (const ProjectedCone& cone : body.cones)
    drawCone(cone, boxOf(cone, margin, size), drawing, depth);
  return drawing;
}

}  // namespace markerless_mocap
