#include "markerless_mocap/capture/camera_ring.h"

#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kPi = 3.14159265358979323846;

CameraCalibration lens(const StudioOptions& options) {
  CameraCalibration c;
  c.width = options.width;
  c.height = options.height;
  const double focal = c.width / 2.0 / std::tan(options.horizontal_view_deg * kPi / 360.0);
  c.K << focal, 0, (c.width - 1) / 2.0, 0, focal, (c.height - 1) / 2.0, 0, 0, 1;
  c.D = {options.distortion_k1, 0, 0, 0, 0};
  return c;
}

}  // namespace

Eigen::Vector3d ringTarget() {
  return {0.0, 0.0, 1.0};
}

CameraRig cameraRing(const StudioOptions& options) {
  options.validate();
  const int in_ring = options.cameras - (options.overhead ? 1 : 0);
  CameraRig rig;
  for (int i = 0; i < options.cameras; ++i) {
    const double angle = 2.0 * kPi * i / in_ring;
    const Eigen::Vector3d in_the_ring(options.ring_radius * std::cos(angle),
                                      options.ring_radius * std::sin(angle), options.ring_height);
    const Eigen::Vector3d above(0.0, 0.0, options.overhead_height);
    CameraCalibration calibration = lens(options);
    calibration.name = "cam" + std::to_string(i);
    calibration.T_world_camera = lookAt(i < in_ring ? in_the_ring : above, ringTarget());
    rig.emplace_back(calibration);
  }
  return rig;
}

}  // namespace markerless_mocap
