#include "capture/scene/room_light.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr float kEdge = 0.03f;  // half the width of a patch's soft edge, metres
/// Middles of the patches, metres.
const Eigen::Vector2f kPatches[] = {{-0.6f, 0.4f}, {0.9f, -0.7f}};
const Eigen::Vector2f kHalfPatch(0.45f, 0.7f);
constexpr float kHalfBar = 0.03f;  // of the cross between the panes

/// 0 below -kEdge, 1 above kEdge.
float ramp(float inside) {
  return std::clamp(0.5f + 0.5f * inside / kEdge, 0.0f, 1.0f);
}

/// How much of the sun a window lets through to a point of the floor.
float throughWindow(const Eigen::Vector2f& from_middle) {
  const Eigen::Vector2f aside = from_middle.cwiseAbs();
  const float in_frame = (kHalfPatch - aside).minCoeff(), beside_bars = aside.minCoeff() - kHalfBar;
  return ramp(in_frame) * ramp(beside_bars);
}

}  // namespace

const Lamp& sunLamp() {
  static const Lamp sun{{4.5f, 3.0f, 9.0f}, 1.0f, 0.06f};
  return sun;
}

Eigen::Vector3f sunlightAt(const RoomLight& light, const Eigen::Vector3f& place) {
  const Eigen::Vector3f color(1.0f, 0.93f, 0.80f);
  const Eigen::Vector3f& sun = sunLamp().position;
  const float stretch = sun.z() / std::max(sun.z() - place.z(), 1.0f);
  const Eigen::Vector2f on_floor =
      sun.head<2>() + stretch * (place.head<2>() - sun.head<2>()) - light.sun_shift;
  float open = 0.0f;
  for (const Eigen::Vector2f& middle : kPatches)
    open = std::max(open, throughWindow(on_floor - middle));
  return color * (light.sun * open);
}

float mainLampAt(const Lamp& main_lamp, const Eigen::Vector3f& place) {
  constexpr float kStrength = 1.5f, kReach = 2.5f;  // metres
  const float aside = (place - main_lamp.position).head<2>().norm() / kReach;
  return kStrength * main_lamp.fraction / (1.0f + aside * aside);
}

}  // namespace markerless_mocap
