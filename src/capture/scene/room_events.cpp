#include "capture/scene/room_events.h"

#include <algorithm>
#include <cmath>

#include "capture/scene/furniture.h"
#include "capture/scene/moving_picture.h"

namespace markerless_mocap {
namespace {

/// Directions of things, seen from the centre, radians.
constexpr double kChairBearing = M_PI, kBroughtBoxBearing = -0.8, kMovedBoxBearing = 0.9;
constexpr double kMovedBoxDistance = 1.9;
constexpr double kMoveTime = 2.0, kMoveSeconds = 0.7;  // of boxes

/// 0 before `begin`, 1 from `end` on, smooth between.
double eased(double seconds, double begin, double end) {
  const double fraction = std::clamp((seconds - begin) / (end - begin), 0.0, 1.0);
  return fraction * fraction * (3.0 - 2.0 * fraction);
}

SceneObject objectOf(const ColoredMesh& mesh, const Eigen::Isometry3d& place) {
  SceneObject object;
  object.mesh = &mesh;
  object.person = false;
  object.vertices.reserve(mesh.vertices.size());
  for (const Eigen::Vector3f& v : mesh.vertices)
    object.vertices.push_back((place * v.cast<double>()).cast<float>());
  return object;
}

SceneObject shiningObject(ColoredMesh mesh) {
  SceneObject object;
  object.vertices = mesh.vertices;
  object.owned = std::make_shared<const ColoredMesh>(std::move(mesh));
  object.mesh = object.owned.get();
  object.person = false;
  object.shines = true;
  return object;
}

}  // namespace

Eigen::Isometry3d placeAt(double distance, double bearing, double heading) {
  Eigen::Isometry3d place(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()));
  place.translation() << distance * std::cos(bearing), distance * std::sin(bearing), 0.0;
  return place;
}

RoomEvents::RoomEvents(const DegradationOptions& degradations, const Eigen::Vector3f& half_size)
    : degradations_(degradations),
      half_size_(half_size),
      chair_(std::make_unique<const ColoredMesh>(chairMesh())),
      box_(std::make_unique<const ColoredMesh>(boxMesh())),
      door_leaf_(std::make_unique<const ColoredMesh>(doorLeafMesh())),
      doorway_(std::make_unique<const ColoredMesh>(doorwayMesh())) {}

void RoomEvents::addObjects(double seconds, std::vector<SceneObject>* objects) const {
  addFurniture(seconds, objects);
  if (degradations_.door_angle > 0.0) addDoor(seconds, objects);
  addPictures(seconds, objects);
}

void RoomEvents::addFurniture(double seconds, std::vector<SceneObject>* objects) const {
  const auto chairAt = [&](double distance) {
    return objectOf(*chair_, placeAt(distance, kChairBearing, kChairBearing + M_PI));
  };
  if (const double distance = degradations_.chair_distance; distance > 0.0)
    objects->push_back(chairAt(distance));
  if (const double distance = degradations_.brought_chair_distance;
      distance > 0.0 && seconds >= 0.0)
    objects->push_back(chairAt(distance));
  if (const double distance = degradations_.brought_box_distance;
      distance > 0.0 && seconds >= kMoveTime)
    objects->push_back(objectOf(*box_, placeAt(distance, kBroughtBoxBearing, 0.4)));
  if (const double way = degradations_.moved_box_shift; way > 0.0) {
    const double moved = way * eased(seconds, kMoveTime, kMoveTime + kMoveSeconds);
    Eigen::Isometry3d place = placeAt(kMovedBoxDistance, kMovedBoxBearing, 0.3);
    place.translate(Eigen::Vector3d(-moved, 0.0, 0.0));
    objects->push_back(objectOf(*box_, place));
  }
}

/// The door is in the middle of the wall at -y.
void RoomEvents::addDoor(double seconds, std::vector<SceneObject>* objects) const {
  constexpr double kPeriod = 6.0, kBegin = 1.0, kOpen = 1.8, kClose = 3.8, kEnd = 4.6;
  const double since = seconds < 0.0 ? 0.0 : std::fmod(seconds, kPeriod);
  const double open = eased(since, kBegin, kOpen) - eased(since, kClose, kEnd);
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() << -0.45, -half_size_.y() + 0.01, 0.0;
  objects->push_back(objectOf(*doorway_, place));
  place.translation().y() += 0.05;
  place.rotate(
      Eigen::AngleAxisd(degradations_.door_angle * M_PI / 180.0 * open, Eigen::Vector3d::UnitZ()));
  objects->push_back(objectOf(*door_leaf_, place));
}

/// The screen is on the wall at -x, the window on the wall at +y.
void RoomEvents::addPictures(double seconds, std::vector<SceneObject>* objects) const {
  constexpr float kBefore = 0.03f, kMiddle = 1.35f;  // metres
  if (const float width = float(degradations_.screen_width); width > 0.0f) {
    const float height = width * 9.0f / 16.0f, x = -half_size_.x() + kBefore;
    const Panel panel{{x, -width / 2, kMiddle - height / 2}, {0, width, 0}, {0, 0, height}};
    objects->push_back(shiningObject(screenMesh(panel, seconds)));
  }
  if (const float width = float(degradations_.window_width); width > 0.0f) {
    const float height = 0.75f * width, y = half_size_.y() - kBefore;
    const Panel panel{{width / 2, y, kMiddle - height / 2}, {-width, 0, 0}, {0, 0, height}};
    objects->push_back(shiningObject(windowMesh(panel, seconds)));
  }
}

RoomLight RoomEvents::lightAt(double seconds) const {
  constexpr double kSwitchSeconds = 2.0;
  RoomLight light;
  if (seconds >= 0.0 && std::fmod(seconds, 2.0 * kSwitchSeconds) >= kSwitchSeconds)
    light.main_lamp = 1.0f - float(degradations_.light_switch);
  light.sun = float(degradations_.sun_patches);
  light.sun_shift << float(0.5 * std::sin(0.4 * seconds)), float(0.35 * std::sin(0.55 * seconds));
  return light;
}

}  // namespace markerless_mocap
