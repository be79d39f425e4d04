#include "capture/scene/furniture.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace markerless_mocap {
namespace {

TEST(FurnitureTest, chairStandsOnTheFloor) {
  Eigen::Vector3f low(9, 9, 9), high(-9, -9, -9);
  float seat = 0.0f;
  for (const Eigen::Vector3f& vertex : chairMesh().vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
    if (vertex.x() > 0.15f) seat = std::max(seat, vertex.z());
  }
  EXPECT_EQ(low.z(), 0.0f);
  EXPECT_NEAR(high.z(), 0.9f, 1e-6f);
  EXPECT_NEAR(seat, 0.45f, 1e-6f);
  EXPECT_LT((high - low).head<2>().maxCoeff(), 0.5f);
}

/// Each edge is passed as often one way as the other: the surfaces are closed and turned alike.
TEST(FurnitureTest, chairIsClosedAndItsNormalsPointOut) {
  const ColoredMesh mesh = chairMesh();
  ASSERT_EQ(mesh.colors.size(), mesh.vertices.size());
  std::map<std::array<float, 6>, int> passes;
  double volume = 0.0;
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3f &a = mesh.vertices[triangle[i]],
                            &b = mesh.vertices[triangle[(i + 1) % 3]];
      ++passes[{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}];
      --passes[{b.x(), b.y(), b.z(), a.x(), a.y(), a.z()}];
    }
    volume += mesh.vertices[triangle[0]].dot(
                  mesh.vertices[triangle[1]].cross(mesh.vertices[triangle[2]])) /
              6.0;
  }
  for (const auto& [edge, balance] : passes) EXPECT_EQ(balance, 0);
  EXPECT_NEAR(volume, 0.0108, 0.003);  // of wood, cubic metres
}

}  // namespace
}  // namespace markerless_mocap
