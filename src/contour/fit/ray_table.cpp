#include "contour/fit/ray_table.h"

#include <algorithm>

namespace markerless_mocap {

RayTable::RayTable(const Camera& camera)
    : columns_(camera.width() / kStep + 2),
      rows_(camera.height() / kStep + 2),
      wide_(camera.calibration().lens == LensType::kFisheye),
      R_world_camera_(camera.calibration().T_world_camera.linear()) {
  nodes_.reserve(size_t(columns_) * size_t(rows_));
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const Eigen::Vector3d ray =
          R_world_camera_.transpose() * camera.rayDirection({x * kStep, y * kStep});
      nodes_.push_back(wide_ ? Eigen::Vector2d(ray.head<2>() / (1 + ray.z())) : ray.hnormalized());
    }
}

Eigen::Vector3d RayTable::direction(const Eigen::Vector2d& pixel) const {
  const double x = std::max(0.0, pixel.x() / kStep), y = std::max(0.0, pixel.y() / kStep);
  const int i = std::min(int(x), columns_ - 2), j = std::min(int(y), rows_ - 2);
  const double u = x - i, v = y - j;
  const Eigen::Vector2d* node = &nodes_[size_t(j) * size_t(columns_) + size_t(i)];
  const Eigen::Vector2d plane = (1 - v) * ((1 - u) * node[0] + u * node[1]) +
                                v * ((1 - u) * node[columns_] + u * node[columns_ + 1]);
  if (!wide_) return R_world_camera_ * plane.homogeneous();
  const double s = plane.squaredNorm();
  return R_world_camera_ * Eigen::Vector3d(2 * plane.x(), 2 * plane.y(), 1 - s);
}

}  // namespace markerless_mocap
