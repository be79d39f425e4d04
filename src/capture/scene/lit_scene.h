#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "capture/scene/textured_room.h"
#include "character/character.h"

namespace markerless_mocap {

/// A mesh put into the room.
struct SceneObject {
  std::vector<Eigen::Vector3f> vertices;  ///< world, metres; one for each of the mesh's
  const ColoredMesh* mesh = nullptr;      ///< colours and triangles; must outlive the scene
  bool person = true;                     ///< whether masks show it
};

class ShadowMap;

/// All objects of one instant under the room's lamps. What does not depend on the camera is worked
/// out here once: smooth normals, each vertex's light, the lamps' shadow maps. Immutable.
class LitScene {
 public:
  /// \param shadow_strength 0 to 1: how much of a lamp's light its shadow takes
  /// Throws std::invalid_argument: a strength out of range, an object without mesh, whose vertices
  /// are not as many as the mesh's or not finite, or a triangle of a vertex that does not exist.
  LitScene(const TexturedRoom& room, std::vector<SceneObject> objects, double shadow_strength);

  const std::vector<SceneObject>& objects() const { return objects_; }
  /// Colour (red green blue, 0 to 1) of each vertex of an object under its light.
  const std::vector<Eigen::Vector3f>& litColors(size_t object) const { return lit_colors_[object]; }
  /// One for each of the room's lamps.
  const std::vector<ShadowMap>& shadowMaps() const { return *shadow_maps_; }
  double shadowStrength() const { return shadow_strength_; }

 private:
  std::vector<SceneObject> objects_;
  double shadow_strength_;
  std::shared_ptr<const std::vector<ShadowMap>> shadow_maps_;
  std::vector<std::vector<Eigen::Vector3f>> lit_colors_;  ///< by object
};

}  // namespace markerless_mocap
