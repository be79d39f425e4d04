#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "capture/render/mesh_renderer.h"
#include "capture/scene/lit_scene.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// 3 m from the z axis and 1 m high, looking along -x.
inline Camera sideCamera(std::vector<double> D = {}) {
  CameraCalibration c;
  c.name = "side";
  c.width = 160;
  c.height = 120;
  c.K << 150, 0, 79.5, 0, 150, 59.5, 0, 0, 1;
  c.D = std::move(D);
  c.T_world_camera.linear() << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  c.T_world_camera.translation() << 3, 0, 1;
  return Camera(c);
}

inline const std::vector<double> kLens = {-0.25, 0.06, 0.002, -0.001};

inline ColoredMesh ball(int rings, const Eigen::Vector3f& color) {
  ColoredMesh mesh;
  const int around = 2 * rings;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double up = M_PI * (double(i) / rings - 0.5), turn = 2.0 * M_PI * j / around;
      const Eigen::Vector3d vertex(std::cos(up) * std::cos(turn), std::cos(up) * std::sin(turn),
                                   std::sin(up));
      mesh.vertices.push_back(vertex.cast<float>());
      mesh.colors.push_back(color);
    }
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const int a = i * around + j, b = i * around + (j + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  return mesh;
}

/// The mesh, scaled and shifted, in the world.
inline SceneObject placed(const ColoredMesh& mesh, float scale, const Eigen::Vector3f& place,
                          bool person = true) {
  SceneObject object{mesh.vertices, &mesh, person};
  for (Eigen::Vector3f& vertex : object.vertices) vertex = scale * vertex + place;
  return object;
}

/// Unconnected triangles of all sizes in a box.
inline ColoredMesh triangleSoup(int count, const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                                uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> fraction(0.0f, 1.0f);
  const auto any = [&] {
    return Eigen::Vector3f(fraction(random), fraction(random), fraction(random));
  };
  ColoredMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f middle = low + any().cwiseProduct(high - low);
    const float size = std::pow(10.0f, -2.0f * fraction(random));
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(middle + size * (2.0f * any() - Eigen::Vector3f::Ones()));
      mesh.colors.push_back(any());
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

}  // namespace markerless_mocap
