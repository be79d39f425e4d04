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

double volumeOf(const ColoredMesh& mesh) {
  double volume = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6.0;
  return volume;
}

/// Each edge is passed as often one way as the other: the surfaces are closed and turned alike.
TEST(FurnitureTest, chairIsClosedAndItsNormalsPointOut) {
  const ColoredMesh mesh = chairMesh();
  ASSERT_EQ(mesh.colors.size(), mesh.vertices.size());
  std::map<std::array<float, 6>, int> passes;
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3f &a = mesh.vertices[triangle[i]],
                            &b = mesh.vertices[triangle[(i + 1) % 3]];
      ++passes[{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}];
      --passes[{b.x(), b.y(), b.z(), a.x(), a.y(), a.z()}];
    }
  }
  for (const auto& [edge, balance] : passes) EXPECT_EQ(balance, 0);
  EXPECT_NEAR(volumeOf(mesh), 0.0108, 0.003);  // of wood, cubic metres
}

TEST(FurnitureTest, boxAndDoorAreClosedAndTheirNormalsPointOut) {
  EXPECT_NEAR(volumeOf(boxMesh()), 0.6 * 0.45 * 0.7, 1e-4);
  EXPECT_NEAR(volumeOf(doorLeafMesh()), 0.9 * 0.04 * 2.05, 1e-4);
}

TEST(FurnitureTest, doorwayIsAsLargeAsTheLeafAndFacesTheRoom) {
  const ColoredMesh mesh = doorwayMesh();
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f &origin = mesh.vertices[a], one = mesh.vertices[b] - origin;
    area += 0.5 * one.cross(mesh.vertices[c] - origin).cast<double>();
  }
  EXPECT_LT((area - Eigen::Vector3d(0, 0.9 * 2.05, 0)).norm(), 1e-4);
}

}  // namespace
}  // namespace markerless_mocap
