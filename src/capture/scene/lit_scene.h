#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "capture/scene/textured_room.h"
#include "character/character.h"

namespace markerless_mocap {

/// A mesh in the room.
struct SceneObject {
  std::vector<Eigen::Vector3f> vertices;  ///< world, metres; one per vertex of the mesh
  const ColoredMesh* mesh = nullptr;      ///< colours and triangles; must outlive the scene
  bool person = true;                     ///< whether masks show it
};

class ShadowMap;

/// All objects at one time under the room's lamps. Everything that does not depend on the camera is
/// computed here once: smooth normals, the light on each vertex, shadow maps. Immutable.
class LitScene {
 public:
  /// \param shadow_strength 0 to 1: fraction of a lamp's light that its shadow removes
  /// Throws std::invalid_argument if the strength is out of range, an object has no mesh, the
  /// number of its vertices differs from the mesh's, a vertex is not finite, or a triangle refers
  /// to a vertex that does not exist.
  LitScene(const TexturedRoom& room, std::vector<SceneObject> objects, double shadow_strength);

  const std::vector<SceneObject>& objects() const { return objects_; }
  /// Colour (red, green, blue, 0 to 1) of each vertex of an object under the light.
  const std::vector<Eigen::Vector3f>& litColors(size_t object) const { return lit_colors_[object]; }
  /// One per lamp of the room.
  const std::vector<ShadowMap>& shadowMaps() const { return *shadow_maps_; }
  double shadowStrength() const { return shadow_strength_; }

 private:
  std::vector<SceneObject> objects_;
  double shadow_strength_;
  std::shared_ptr<const std::vector<ShadowMap>> shadow_maps_;
  std::vector<std::vector<Eigen::Vector3f>> lit_colors_;  ///< by object
};

}  // namespace markerless_mocap
