#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// Camera of 160 x 120 pixels at `position` that looks at `target`.
inline Camera makeCamera(const std::string& name, const Eigen::Vector3d& position,
                         const Eigen::Vector3d& target, std::vector<double> D = {},
                         double focal = 150) {
  CameraCalibration c;
  c.name = name;
  c.width = 160;
  c.height = 120;
  c.K << focal, 0, 79.5, 0, focal, 59.5, 0, 0, 1;
  c.D = std::move(D);
  const Eigen::Vector3d z = (target - position).normalized();
  const Eigen::Vector3d helper =
      std::abs(z.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d x = z.cross(helper).normalized();
  c.T_world_camera.linear() << x, z.cross(x), z;
  c.T_world_camera.translation() = position;
  return Camera(c);
}

/// Cameras spread evenly over a sphere of 3 m around the origin.
inline CameraRig makeRig(int cameras, const std::vector<double>& D = {}) {
  CameraRig rig;
  for (int i = 0; i < cameras; ++i) {
    const double z = 1 - (2 * i + 1.0) / cameras, r = std::sqrt(1 - z * z), a = 2.4 * i;
    rig.push_back(makeCamera("cam" + std::to_string(i),
                             3 * Eigen::Vector3d(r * std::cos(a), r * std::sin(a), z),
                             Eigen::Vector3d::Zero(), D));
  }
  return rig;
}

struct Sphere {
  Eigen::Vector3d center{0, 0, 0};
  double radius = 0.4;
};

/// Silhouette of spheres by intersecting the ray of each pixel.
inline cv::Mat renderMask(const Camera& camera, const std::vector<Sphere>& spheres) {
  cv::Mat mask = cv::Mat::zeros(camera.height(), camera.width(), CV_8UC1);
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) {
      const Eigen::Vector3d ray = camera.rayDirection(Eigen::Vector2d(x, y));
      for (const Sphere& s : spheres) {
        const Eigen::Vector3d to_center = s.center - camera.position();
        if (ray.dot(to_center) > 0 && ray.cross(to_center).norm() < s.radius)
          mask.at<uint8_t>(y, x) = 255;
      }
    }
  return mask;
}

inline std::vector<HullView> renderViews(const CameraRig& rig, const std::vector<Sphere>& spheres) {
  std::vector<HullView> views(rig.size());
  for (size_t c = 0; c < rig.size(); ++c) views[c].mask = renderMask(rig[c], spheres);
  return views;
}

/// A cube of +-0.6 m at 40 mm.
inline HullOptions makeOptions() {
  HullOptions options;
  options.volume = "explicit";
  options.volume_min = {-0.6, -0.6, -0.6};
  options.volume_max = {0.6, 0.6, 0.6};
  options.pitch = 0.04;
  return options;
}

inline std::vector<uint32_t> indices(const VisualHull& hull) {
  std::vector<uint32_t> all;
  for (const HullVoxel& voxel : hull.voxels) all.push_back(voxel.index);
  return all;
}

}  // namespace markerless_mocap
