#include "capture/scene/textured_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "capture/scene/room_texture.h"

namespace markerless_mocap {
namespace {

constexpr double kBlur = 1.5e-3;  // fraction of the distance: resolution of a camera
constexpr double kMinHalf = 1.0, kMaxHalf = 50.0, kMinHeight = 2.0, kMaxHeight = 20.0;

void checkSize(const std::string& what, double value, double min, double max) {
  if (!(value >= min && value <= max))
    throw std::invalid_argument("the room's " + what + " is " + std::to_string(value) +
                                " m, allowed is " + std::to_string(int(min)) + " to " +
                                std::to_string(int(max)));
}

}  // namespace

TexturedRoom::TexturedRoom(uint64_t seed, double half_x, double half_y, double height)
    : half_size_(float(half_x), float(half_y), float(height)),
      texture_(std::make_shared<RoomTexture>(seed, half_size_)) {
  checkSize("half size in x", half_x, kMinHalf, kMaxHalf);
  checkSize("half size in y", half_y, kMinHalf, kMaxHalf);
  checkSize("height", height, kMinHeight, kMaxHeight);
  const float z = half_size_.z() - 0.05f;
  const auto hang = [&](float x, float y, float fraction, float radius) {
    lamps_.push_back({{x * half_size_.x(), y * half_size_.y(), z}, fraction, radius});
  };
  hang(0.35f, 0.25f, 0.45f, 0.12f);
  hang(-0.45f, 0.30f, 0.25f, 0.15f);
  hang(0.05f, -0.50f, 0.15f, 0.20f);
  hang(0.02f, 0.03f, 0.15f, 0.30f);  // offset for cameras below
}

TexturedRoom TexturedRoom::around(uint64_t seed, const CameraRig& rig) {
  constexpr double kSpace = 1.5, kSpaceAbove = 0.4;
  double half = 5.0, height = 3.2;
  for (const Camera& camera : rig) {
    const Eigen::Vector3d place = camera.position();
    if (!(place.z() > 0.0))
      throw std::invalid_argument("camera '" + camera.name() + "' is " + std::to_string(place.z()) +
                                  " m above the floor, it must be inside the room");
    half = std::max(half, place.head<2>().cwiseAbs().maxCoeff() + kSpace);
    height = std::max(height, place.z() + kSpaceAbove);
  }
  return TexturedRoom(seed, half, half, height);
}

RoomPoint TexturedRoom::at(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const {
  double nearest = std::numeric_limits<double>::infinity();
  int axis = 2;
  for (int i = 0; i < 3; ++i) {
    if (direction[i] == 0.0) continue;
    const double low = i == 2 ? 0.0 : -double(half_size_[i]);
    const double distance = ((direction[i] > 0.0 ? half_size_[i] : low) - eye[i]) / direction[i];
    if (distance < nearest) {
      nearest = distance;
      axis = i;
    }
  }
  RoomPoint point;
  point.position = (eye + nearest * direction).cast<float>();
  const double distance = nearest * direction.norm();
  const double slant = std::abs(direction[axis]) / direction.norm();
  point.color =
      texture_->color(point.position, axis, direction[axis] > 0.0, float(kBlur * distance / slant));
  return point;
}

Eigen::Vector3f TexturedRoom::wallColor() const {
  return texture_->wallColor();
}

}  // namespace markerless_mocap
