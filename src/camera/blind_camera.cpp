#include "camera/blind_camera.h"

namespace markerless_mocap {
namespace {

constexpr double kDepth = 9999.0;  // m below the world's origin

}  // namespace

Camera blindCamera(const std::string& name) {
  CameraCalibration calibration;
  calibration.name = name;
  calibration.width = 64;
  calibration.height = 48;
  calibration.K << 64.0, 0.0, 31.5, 0.0, 64.0, 23.5, 0.0, 0.0, 1.0;
  calibration.T_world_camera.linear() =
      Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  calibration.T_world_camera.translation().z() = -kDepth;
  return Camera(calibration);
}

bool isBlind(const Camera& camera) {
  return camera.position() == Eigen::Vector3d(0.0, 0.0, -kDepth);
}

}  // namespace markerless_mocap
