#include "capture/render/triangle_rasterizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace markerless_mocap {
namespace {

/// A vertex relative to the camera.
struct Corner {
  Eigen::Vector3d point;  ///< camera frame
  Eigen::Vector2d place;  ///< grid position, NaN if it has none
};

/// a x b, exactly the negative of b x a for any fusing of operations by the compiler.
Eigen::Vector3d orderedCross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const bool swapped = std::lexicographical_compare(b.data(), b.data() + 3, a.data(), a.data() + 3);
  return swapped ? Eigen::Vector3d(-b.cross(a)) : Eigen::Vector3d(a.cross(b));
}

/// A ray through an edge of two triangles belongs to exactly one of them.
bool ownsZero(const Eigen::Vector3d& edge) {
  if (edge.x() != 0.0) return edge.x() > 0.0;
  return edge.y() != 0.0 ? edge.y() > 0.0 : edge.z() > 0.0;
}

/// The three edge functions of a triangle. A ray (x, y, 1) hits it if none is negative; divided by
/// their sum they are the weights of the corners.
struct Edges {
  Eigen::Vector3d e[3];
  bool owns[3];
  double volume;  ///< six times the volume of the tetrahedron with the camera's centre

  Edges(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
      : e{orderedCross(b, c), orderedCross(c, a), orderedCross(a, b)}, volume(a.dot(e[0])) {
    if (volume < 0.0) {
      for (Eigen::Vector3d& edge : e) edge = -edge;
      volume = -volume;
    }
    for (int i = 0; i < 3; ++i) owns[i] = ownsZero(e[i]);
  }

  bool meets(double x, double y, double (&value)[3]) const {
    for (int i = 0; i < 3; ++i) {
      value[i] = e[i].x() * x + e[i].y() * y + e[i].z();
      if (value[i] < 0.0 || (value[i] == 0.0 && !owns[i])) return false;
    }
    return true;
  }
};

/// Grid positions that a triangle in front of the camera may cover.
cv::Rect boxOf(const SampleGrid& grid, const Corner* const (&corners)[3]) {
  Eigen::Vector2d low = corners[0]->place, high = low;
  Eigen::Vector2d plane_low = corners[0]->point.hnormalized(), plane_high = plane_low;
  for (int i = 1; i < 3; ++i) {
    low = low.cwiseMin(corners[i]->place);
    high = high.cwiseMax(corners[i]->place);
    const Eigen::Vector2d plane = corners[i]->point.hnormalized();
    plane_low = plane_low.cwiseMin(plane);
    plane_high = plane_high.cwiseMax(plane);
  }
  const double margin = grid.margin((plane_high - plane_low).norm()) + 1e-3;
  const cv::Size size = grid.size();
  const auto bound = [](double v, int max) { return int(std::clamp(v, 0.0, double(max))); };
  const cv::Point from(bound(std::ceil(low.x() - margin), size.width),
                       bound(std::ceil(low.y() - margin), size.height));
  const cv::Point to(bound(std::floor(high.x() + margin) + 1.0, size.width),
                     bound(std::floor(high.y() + margin) + 1.0, size.height));
  return from.x < to.x && from.y < to.y ? cv::Rect(from, to) : cv::Rect();
}

/// The same for a triangle with corners behind the camera or far outside its view.
cv::Rect boxOfCut(const SampleGrid& grid, const Corner* const (&corners)[3]) {
  constexpr double kNear = 1e-3;  // metres; nearer parts are not drawn exactly
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  const auto add = [&](const Eigen::Vector3d& point) {
    low = low.cwiseMin(point.hnormalized());
    high = high.cwiseMax(point.hnormalized());
  };
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d &a = corners[i]->point, &b = corners[(i + 1) % 3]->point;
    if (a.z() >= kNear) add(a);
    if ((a.z() < kNear) != (b.z() < kNear)) {
      Eigen::Vector3d cut = a + (kNear - a.z()) / (b.z() - a.z()) * (b - a);
      cut.z() = kNear;
      add(cut);
    }
  }
  return grid.placesWithin(low, high);
}

cv::Rect placesOf(const SampleGrid& grid, const Corner* const (&corners)[3]) {
  bool all_placed = true, any_before = false;
  for (const Corner* corner : corners) {
    all_placed = all_placed && !std::isnan(corner->place.x());
    any_before = any_before || corner->point.z() > 0.0;
  }
  if (all_placed) return boxOf(grid, corners);
  return any_before ? boxOfCut(grid, corners) : cv::Rect();
}

std::vector<Corner> cornersOf(const SampleGrid& grid, const SceneObject& object, bool mirrored) {
  std::vector<Corner> corners(object.vertices.size());
  for (size_t i = 0; i < corners.size(); ++i) {
    Eigen::Vector3d vertex = object.vertices[i].cast<double>();
    if (mirrored) vertex.z() = -vertex.z();
    corners[i].point = grid.worldToCamera() * vertex;
    corners[i].place = grid.place(corners[i].point);
  }
  return corners;
}

/// A triangle that may be visible.
struct Candidate {
  uint32_t object, triangle;
  cv::Rect box;
};

void draw(const SampleGrid& grid, const Edges& edges, const cv::Rect& box,
          const Eigen::Vector3f* const (&colors)[3], Sample::Kind kind, SampleBuffer& buffer) {
  double value[3];
  for (int y = box.y; y < box.y + box.height; ++y) {
    const Eigen::Vector2f* const plane = grid.row(y);
    Sample* const samples = buffer.row(y);
    for (int x = box.x; x < box.x + box.width; ++x) {
      if (!edges.meets(plane[x].x(), plane[x].y(), value)) continue;
      const double sum = value[0] + value[1] + value[2];
      const float depth = float(edges.volume / sum);
      Sample& sample = samples[x];
      if (!(depth < sample.depth)) continue;
      const float scale = float(255.0 / sum);
      for (int channel = 0; channel < 3; ++channel) {
        float level = 0.5f;
        for (int i = 0; i < 3; ++i) level += scale * float(value[i]) * (*colors[i])[2 - channel];
        sample.bgr[channel] = uint8_t(std::clamp(level, 0.0f, 255.0f));
      }
      sample.depth = depth;
      sample.kind = kind;
    }
  }
}

/// Extends a box to whole pixels with their neighbour samples.
cv::Rect wholePixels(const cv::Rect& rect, const cv::Size& size) {
  if (rect.empty()) return {};
  const cv::Point from((std::max(rect.x - 1, 0) / 2) * 2, (std::max(rect.y - 1, 0) / 2) * 2);
  const cv::Point to(std::min((rect.br().x + 1) / 2 * 2 + 1, size.width),
                     std::min((rect.br().y + 1) / 2 * 2 + 1, size.height));
  return {from, to};
}

}  // namespace

SampleBuffer rasterize(const SampleGrid& grid, const LitScene& scene, bool mirrored) {
  std::vector<std::vector<Corner>> corners;
  std::vector<Candidate> candidates;
  cv::Rect covered;
  for (uint32_t o = 0; o < scene.objects().size(); ++o) {
    corners.push_back(cornersOf(grid, scene.objects()[o], mirrored));
    const auto& triangles = scene.objects()[o].mesh->triangles;
    for (uint32_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      const cv::Rect box = placesOf(grid, {&corners[o][a], &corners[o][b], &corners[o][c]});
      if (box.empty()) continue;
      candidates.push_back({o, t, box});
      covered |= box;
    }
  }
  SampleBuffer buffer;
  buffer.rect = wholePixels(covered, grid.size());
  buffer.samples.assign(size_t(buffer.rect.area()),
                        {std::numeric_limits<float>::infinity(), {0, 0, 0}, Sample::kNothing});
  for (const Candidate& candidate : candidates) {
    const SceneObject& object = scene.objects()[candidate.object];
    const auto& [a, b, c] = object.mesh->triangles[candidate.triangle];
    const auto& points = corners[candidate.object];
    const auto& colors = scene.litColors(candidate.object);
    const Edges edges(points[a].point, points[b].point, points[c].point);
    if (edges.volume > 0.0)
      draw(grid, edges, candidate.box, {&colors[a], &colors[b], &colors[c]},
           object.person ? Sample::kPerson : Sample::kObject, buffer);
  }
  return buffer;
}

}  // namespace markerless_mocap
