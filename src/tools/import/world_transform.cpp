#include "tools/import/world_transform.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kMaxRig = 50.0, kMinRig = 0.2;  // metres

/// Unit vector of "x", "-x" ...; zero if the text is not an axis.
Eigen::Vector3d axisNamed(const std::string& name) {
  const double sign = name[0] == '-' ? -1.0 : 1.0;
  const std::string letter = name.substr(sign < 0.0 ? 1 : 0);
  if (letter == "x") return sign * Eigen::Vector3d::UnitX();
  if (letter == "y") return sign * Eigen::Vector3d::UnitY();
  if (letter == "z") return sign * Eigen::Vector3d::UnitZ();
  return Eigen::Vector3d::Zero();
}

}  // namespace

void WorldTransform::validate() const {
  if (!(scale_to_metres > 0.0 && scale_to_metres <= 1000.0)) {
    std::ostringstream message;
    message << "scale-to-metres is " << scale_to_metres
            << ", allowed is above 0 to 1000 (0.001 for millimetres)";
    throw std::invalid_argument(message.str());
  }
  if (axisNamed(up).isZero())
    throw std::invalid_argument("up is \"" + up + "\", allowed is one of x, -x, y, -y, z, -z");
}

Eigen::Matrix3d WorldTransform::rotation() const {
  const Eigen::Vector3d axis = axisNamed(up);
  // For a rotation by 180 degrees the shortest rotation is ambiguous: it is about x.
  if (axis.z() < -0.5) return Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return Eigen::Quaterniond::FromTwoVectors(axis, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

CameraCalibration WorldTransform::apply(CameraCalibration calibration) const {
  Eigen::Isometry3d& pose = calibration.T_world_camera;
  pose.linear() = rotation() * pose.linear();
  pose.translation() = scale_to_metres * (rotation() * pose.translation());
  return calibration;
}

std::vector<std::string> calibrationWarnings(const std::vector<CameraCalibration>& cameras) {
  double nearest = INFINITY, furthest = 0.0, highest = -INFINITY;
  for (size_t i = 0; i < cameras.size(); ++i) {
    const Eigen::Vector3d position = cameras[i].T_world_camera.translation();
    highest = std::max(highest, position.z());
    for (size_t j = 0; j < i; ++j) {
      const double distance = (position - cameras[j].T_world_camera.translation()).norm();
      nearest = std::min(nearest, distance);
      furthest = std::max(furthest, distance);
    }
  }
  std::vector<std::string> warnings;
  if (furthest > kMaxRig)
    warnings.push_back("two cameras are " + std::to_string(int(furthest)) +
                       " m apart: is the unit right (--scale-to-metres)?");
  if (nearest < kMinRig)
    warnings.push_back(
        "two cameras are less than 0.2 m apart: is the unit right "
        "(--scale-to-metres)?");
  if (highest < 0.0)
    warnings.push_back("all cameras are below z = 0: does another axis point up (--up -z)?");
  return warnings;
}

}  // namespace markerless_mocap
