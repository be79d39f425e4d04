#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "capture/scene/textured_room.h"

namespace markerless_mocap {

/// Number of the room's lamp that can be switched.
constexpr size_t kMainLamp = 0;

/// How the light of the room differs from usual.
struct RoomLight {
  float main_lamp = 1.0f;  ///< fraction of the main lamp's light that is on
  float sun = 0.0f;        ///< brightness of the sun, relative to all lamps
  Eigen::Vector2f sun_shift = Eigen::Vector2f::Zero();  ///< of the patches over the floor, metres

  bool usual() const { return main_lamp == 1.0f && sun == 0.0f; }
};

/// The sun as a small lamp far above the ceiling.
const Lamp& sunLamp();

/// Light (red, green, blue) of the sun at a place of the room that nothing hides, on a surface that
/// faces the sun: that of the panes of two windows, wherever the sun's rays through them go.
Eigen::Vector3f sunlightAt(const RoomLight& light, const Eigen::Vector3f& place);

/// Fraction of the light of the room's surface at a place that the main lamp gives, when it is on.
float mainLampAt(const Lamp& main_lamp, const Eigen::Vector3f& place);

}  // namespace markerless_mocap
