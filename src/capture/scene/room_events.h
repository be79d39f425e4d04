#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "capture/degradation_options.h"
#include "capture/scene/lit_scene.h"

namespace markerless_mocap {

/// Things of the room that are not the person: furniture, a door, a screen, a window, lamps and
/// sun, and how they change during the film. Immutable.
class RoomEvents {
 public:
  /// \param half_size of the room, as TexturedRoom::halfSize()
  RoomEvents(const DegradationOptions& degradations, const Eigen::Vector3f& half_size);

  /// \param seconds since the person came; below 0 the room is empty
  void addObjects(double seconds, std::vector<SceneObject>* objects) const;
  RoomLight lightAt(double seconds) const;

 private:
  void addFurniture(double seconds, std::vector<SceneObject>* objects) const;
  void addDoor(double seconds, std::vector<SceneObject>* objects) const;
  void addPictures(double seconds, std::vector<SceneObject>* objects) const;

  DegradationOptions degradations_;
  Eigen::Vector3f half_size_;
  std::unique_ptr<const ColoredMesh> chair_, box_, door_leaf_, doorway_;
};

/// Turned by `heading` about the z axis, then put at a distance and bearing from the centre.
Eigen::Isometry3d placeAt(double distance, double bearing, double heading);

}  // namespace markerless_mocap
