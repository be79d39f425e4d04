#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "capture/scene/room_light.h"
#include "capture/scene/textured_room.h"
#include "character/character.h"

namespace markerless_mocap {

/// A mesh in the room.
struct SceneObject {
  std::vector<Eigen::Vector3f> vertices;  ///< world, metres; one per vertex of the mesh
  const ColoredMesh* mesh = nullptr;      ///< colours and triangles; must outlive the scene
  bool person = true;                     ///< whether masks show it
  bool shines = false;                    ///< its colours are its own light, and it casts no shadow
  std::shared_ptr<const ColoredMesh> owned = nullptr;  ///< the mesh, if nobody else keeps it
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
  LitScene(const TexturedRoom& room, std::vector<SceneObject> objects, double shadow_strength,
           const RoomLight& light = {});

  const std::vector<SceneObject>& objects() const { return objects_; }
  /// Colour (red, green, blue, 0 to 1) of each vertex of an object under the light.
  const std::vector<Eigen::Vector3f>& litColors(size_t object) const { return lit_colors_[object]; }
  /// One per lamp of the room.
  const std::vector<ShadowMap>& shadowMaps() const { return *shadow_maps_; }
  double shadowStrength() const { return shadow_strength_; }
  const RoomLight& light() const { return light_; }
  /// Fraction of the light of a lamp of the room that is on.
  float lampOn(size_t lamp) const { return lamp == kMainLamp ? light_.main_lamp : 1.0f; }
  /// Of the sun; nullptr if it does not shine.
  const ShadowMap* sunShadow() const { return sun_shadow_.get(); }

 private:
  float lampsAt(const TexturedRoom& room, const Eigen::Vector3f& point,
                const Eigen::Vector3f& normal) const;
  Eigen::Vector3f sunAt(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const;
  void lightObject(const TexturedRoom& room, size_t object);

  std::vector<SceneObject> objects_;
  double shadow_strength_;
  RoomLight light_;
  std::shared_ptr<const ShadowMap> sun_shadow_;
  std::shared_ptr<const std::vector<ShadowMap>> shadow_maps_;
  std::vector<std::vector<Eigen::Vector3f>> lit_colors_;  ///< by object
};

}  // namespace markerless_mocap
