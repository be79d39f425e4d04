#include "markerless_mocap/formats/world_transform.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxRig = 50.0, kMinRig = 0.2;  // metres
constexpr double kMaxRigInMetres = 100.0;        // units; more are millimetres
constexpr double kClearUp = 0.5;                 // of the mean direction, per axis

/// Unit vector of "x", "-x" ...; zero if the text is not an axis.
Eigen::Vector3d axisNamed(const std::string& name) {
  const double sign = name[0] == '-' ? -1.0 : 1.0;
  const std::string letter = name.substr(sign < 0.0 ? 1 : 0);
  if (letter == "x") return sign * Eigen::Vector3d::UnitX();
  if (letter == "y") return sign * Eigen::Vector3d::UnitY();
  if (letter == "z") return sign * Eigen::Vector3d::UnitZ();
  return Eigen::Vector3d::Zero();
}

double largestDistance(const std::vector<CameraCalibration>& cameras) {
  double furthest = 0.0;
  for (const CameraCalibration& a : cameras)
    for (const CameraCalibration& b : cameras)
      furthest = std::max(furthest,
                          (a.T_world_camera.translation() - b.T_world_camera.translation()).norm());
  return furthest;
}

Eigen::Vector3d meanImageUp(const std::vector<CameraCalibration>& cameras) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const CameraCalibration& camera : cameras) sum -= camera.T_world_camera.linear().col(1);
  return sum / double(std::max<size_t>(cameras.size(), 1));
}

void guessUnit(const CalibrationSet& set, WorldGuess* guess) {
  std::ostringstream reason;
  if (set.metres_per_unit) {
    guess->world.scale_to_metres = *set.metres_per_unit;
    reason << "the format's";
  } else {
    const double distance = largestDistance(set.cameras);
    guess->world.scale_to_metres = distance > kMaxRigInMetres ? 0.001 : 1.0;
    reason << "guessed, the cameras are up to " << std::fixed
           << std::setprecision(distance < 100.0 ? 1 : 0) << distance << " units apart";
  }
  guess->unit_reason = reason.str();
}

void guessUp(const std::vector<CameraCalibration>& cameras, WorldGuess* guess) {
  const Eigen::Vector3d up = meanImageUp(cameras);
  Eigen::Index axis = 0;
  const double clear = up.cwiseAbs().maxCoeff(&axis);
  if (clear < kClearUp) {
    guess->up_reason = "assumed, the images' up directions agree on no axis";
    return;
  }
  guess->world.up = (up[axis] < 0.0 ? "-" : "") + std::string(1, "xyz"[axis]);
  std::ostringstream reason;
  reason << "guessed, on average the images' up is " << std::fixed << std::setprecision(2) << up.x()
         << ' ' << up.y() << ' ' << up.z();
  guess->up_reason = reason.str();
}

}  // namespace

WorldGuess guessWorld(const CalibrationSet& set) {
  WorldGuess guess;
  guessUnit(set, &guess);
  guessUp(set.cameras, &guess);
  return guess;
}

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
  return shortestRotation(axis, Eigen::Vector3d::UnitZ()).toRotationMatrix();
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
