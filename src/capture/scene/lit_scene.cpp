#include "capture/scene/lit_scene.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "capture/scene/shadow_map.h"

namespace markerless_mocap {
namespace {

// Light on a white surface: ambient light, more from above than from below, and light of all lamps.
constexpr float kAmbientAbove = 0.55f, kAmbientBelow = 0.30f, kLamps = 0.75f;

[[noreturn]] void throwError(size_t object, const std::string& what) {
  throw std::invalid_argument("scene object " + std::to_string(object) + ": " + what);
}

void validate(const SceneObject& object, size_t number) {
  if (!object.mesh) throwError(number, "it has no mesh");
  const size_t count = object.vertices.size();
  if (count != object.mesh->vertices.size() || count != object.mesh->colors.size())
    throwError(number, std::to_string(count) + " vertices for a mesh of " +
                           std::to_string(object.mesh->vertices.size()) + " vertices and " +
                           std::to_string(object.mesh->colors.size()) +
                           " colours, the three must be equal");
  for (const Eigen::Vector3f& vertex : object.vertices)
    if (!vertex.allFinite()) throwError(number, "a vertex is not finite");
  for (const auto& triangle : object.mesh->triangles)
    for (const int corner : triangle)
      if (corner < 0 || size_t(corner) >= count)
        throwError(number, "a triangle has vertex " + std::to_string(corner) +
                               ", allowed is 0 to " + std::to_string(count) + " - 1");
}

/// Unit normals of the vertices: means of the triangles' normals, weighted by area.
std::vector<Eigen::Vector3f> smoothNormals(const SceneObject& object) {
  std::vector<Eigen::Vector3f> normals(object.vertices.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : object.mesh->triangles) {
    const Eigen::Vector3f& origin = object.vertices[a];
    const Eigen::Vector3f normal = (object.vertices[b] - origin).cross(object.vertices[c] - origin);
    normals[a] += normal;
    normals[b] += normal;
    normals[c] += normal;
  }
  for (Eigen::Vector3f& normal : normals) normal.normalize();
  return normals;
}

std::vector<ShadowMap> castShadows(const TexturedRoom& room,
                                   const std::vector<SceneObject>& objects) {
  std::vector<std::optional<ShadowMap>> made(room.lamps().size());
  tbb::parallel_for(size_t(0), made.size(),
                    [&](size_t i) { made[i].emplace(room.lamps()[i], objects); });
  std::vector<ShadowMap> maps;
  for (auto& map : made) maps.push_back(std::move(*map));
  return maps;
}

}  // namespace

LitScene::LitScene(const TexturedRoom& room, std::vector<SceneObject> objects,
                   double shadow_strength, const RoomLight& light)
    : objects_(std::move(objects)), shadow_strength_(shadow_strength), light_(light) {
  if (!(shadow_strength >= 0.0 && shadow_strength <= 1.0))
    throw std::invalid_argument("the shadows' strength is " + std::to_string(shadow_strength) +
                                ", allowed is 0 to 1");
  for (size_t i = 0; i < objects_.size(); ++i) validate(objects_[i], i);
  shadow_maps_ = std::make_shared<const std::vector<ShadowMap>>(castShadows(room, objects_));
  if (light_.sun > 0.0f) sun_shadow_ = std::make_shared<const ShadowMap>(sunLamp(), objects_);
  lit_colors_.resize(objects_.size());
  for (size_t i = 0; i < objects_.size(); ++i) lightObject(room, i);
}

void LitScene::lightObject(const TexturedRoom& room, size_t number) {
  const SceneObject& object = objects_[number];
  std::vector<Eigen::Vector3f>& colors = lit_colors_[number];
  colors = object.mesh->colors;
  if (object.shines) return;
  const std::vector<Eigen::Vector3f> normals = smoothNormals(object);
  const tbb::blocked_range<size_t> all(0, object.vertices.size(), 1024);
  tbb::parallel_for(all, [&](const tbb::blocked_range<size_t>& range) {
    for (size_t v = range.begin(); v < range.end(); ++v) {
      const Eigen::Vector3f &point = object.vertices[v], &normal = normals[v];
      const Eigen::Vector3f sun = sunAt(point, normal).cwiseProduct(colors[v]);
      colors[v] = colors[v] * lampsAt(room, point, normal) + sun;
    }
  });
}

float LitScene::lampsAt(const TexturedRoom& room, const Eigen::Vector3f& point,
                        const Eigen::Vector3f& normal) const {
  float light = kAmbientBelow + (kAmbientAbove - kAmbientBelow) * 0.5f * (1.0f + normal.z());
  for (size_t i = 0; i < room.lamps().size(); ++i) {
    const Lamp& lamp = room.lamps()[i];
    const float facing = normal.dot((lamp.position - point).normalized());
    if (facing <= 0.0f) continue;
    const float seen = 1.0f - float(shadow_strength_) * shadowMaps()[i].occludedFraction(point);
    light += kLamps * lamp.fraction * facing * seen * lampOn(i);
  }
  return light;
}

Eigen::Vector3f LitScene::sunAt(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const {
  if (!sun_shadow_) return Eigen::Vector3f::Zero();
  const float facing = normal.dot((sunLamp().position - point).normalized());
  if (facing <= 0.0f) return Eigen::Vector3f::Zero();
  return sunlightAt(light_, point) * (facing * (1.0f - sun_shadow_->occludedFraction(point)));
}

}  // namespace markerless_mocap
