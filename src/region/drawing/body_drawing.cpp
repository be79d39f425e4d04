#include "region/body_drawing.h"

#include <algorithm>
#include <cmath>

#include "numerics/simd_clones.h"

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

/// The convex hull of two disks in plain numbers.
struct PlainCone {
  float x, y, along_x, along_y;  ///< middle of the first disk, and the direction to the other one
  float radius_a, radius_b, length, sine, cosine;  ///< of the tangent to the axis
};

PlainCone plain(const ProjectedCone& cone) {
  const Eigen::Vector2f way = cone.b - cone.a;
  const float length = way.norm(), taper = cone.radius_a - cone.radius_b;
  if (!(std::abs(taper) < length)) {  // one disk contains the other
    const Eigen::Vector2f& middle = taper < 0 ? cone.b : cone.a;
    const float radius = std::max(cone.radius_a, cone.radius_b);
    return {middle.x(), middle.y(), 1, 0, radius, radius, 0, 1, 0};
  }
  const float sine = taper / length;
  return {cone.a.x(),       cone.a.y(),    way.x() / length,
          way.y() / length, cone.radius_a, cone.radius_b,
          length,           sine,          std::sqrt(1 - sine * sine)};
}

/// Distances from the outline in a row, negative inside. Along the axis a point is nearest to one
/// of the disks or to the tangent between them.
MOCAP_VECTORISED void measureRow(const PlainCone& cone, int y, int first, int count,
                                 float* __restrict distances) {
  const float dy = float(y) - cone.y, end = cone.cosine * cone.length;
  for (int i = 0; i < count; ++i) {
    const float dx = float(first + i) - cone.x;
    const float v = cone.along_x * dx + cone.along_y * dy, w = v - cone.length;
    const float u = __builtin_fabsf(cone.along_x * dy - cone.along_y * dx);
    const float from_a = __builtin_sqrtf(u * u + v * v) - cone.radius_a;
    const float from_b = __builtin_sqrtf(u * u + w * w) - cone.radius_b;
    const float between = cone.cosine * u + cone.sine * v - cone.radius_a;
    const float k = cone.cosine * v - cone.sine * u;
    const float past_a = k > end ? from_b : between;
    distances[i] = k <= 0 ? from_a : past_a;
  }
}

MOCAP_VECTORISED void takeLess(const float* __restrict values, int count, float* __restrict least) {
  for (int i = 0; i < count; ++i) least[i] = values[i] < least[i] ? values[i] : least[i];
}

void grow(const cv::Rect& box, cv::Rect& all) {
  if (box.area() > 0) all = all.area() > 0 ? (all | box) : box;
}

/// One row of a cone's box.
void measureRow(const PlainCone& cone, const cv::Rect& box, int y, std::vector<float>& distances) {
  distances.resize(size_t(box.width));
  measureRow(cone, box.y + y, box.x, box.width, distances.data());
}

void drawCone(const ProjectedCone& cone, const cv::Rect& box, BodyDrawing& drawing,
              cv::Mat& depth) {
  const PlainCone outline = plain(cone);
  PartDistance& part = drawing.parts[size_t(cone.part)];
  const float front = std::min(cone.depth_a, cone.depth_b);
  const cv::Point at = box.tl() - drawing.box.tl(), at_part = box.tl() - part.box.tl();
  std::vector<float> distances;
  for (int y = 0; y < box.height; ++y) {
    measureRow(outline, box, y, distances);
    takeLess(distances.data(), box.width, part.distance.ptr<float>(at_part.y + y) + at_part.x);
    takeLess(distances.data(), box.width, drawing.distance.ptr<float>(at.y + y) + at.x);
    uchar* label = drawing.part.ptr<uchar>(at.y + y) + at.x;
    float* z = depth.ptr<float>(at.y + y) + at.x;
    for (int x = 0; x < box.width; ++x) {
      if (distances[size_t(x)] > 0) continue;
      part.depth_inside = std::max(part.depth_inside, -distances[size_t(x)]);
      if (front < z[x]) {
        z[x] = front;
        label[x] = uchar(cone.part);
      }
    }
  }
}

}  // namespace

BodyDistance distanceFrom(const ProjectedBody& body, const cv::Size& size, float margin) {
  BodyDistance all;
  for (const ProjectedCone& cone : body.cones) grow(boxOf(cone, margin, size), all.box);
  all.distance = cv::Mat(all.box.size(), CV_32FC1, cv::Scalar(kFar));
  std::vector<float> distances;
  for (const ProjectedCone& cone : body.cones) {
    const PlainCone outline = plain(cone);
    const cv::Rect box = boxOf(cone, margin, size);
    const cv::Point at = box.tl() - all.box.tl();
    for (int y = 0; y < box.height; ++y) {
      measureRow(outline, box, y, distances);
      takeLess(distances.data(), box.width, all.distance.ptr<float>(at.y + y) + at.x);
    }
  }
  return all;
}

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
