#include "pages/player_hulls.h"

#include <gtest/gtest.h>

#include "pages/page_reader.h"

namespace markerless_mocap {
namespace {

VisualHull hullOf(double pitch, const std::vector<Eigen::Vector3i>& cells) {
  VisualHull hull;
  hull.lattice.origin = {1, 2, 0};
  hull.lattice.pitch = pitch;
  hull.lattice.size = {40, 40, 40};
  for (const Eigen::Vector3i& c : cells) {
    hull.voxels.emplace_back();
    hull.voxels.back().index = hull.lattice.index(c.x(), c.y(), c.z());
  }
  return hull;
}

std::vector<Eigen::Vector3i> block(int begin, int end) {
  std::vector<Eigen::Vector3i> cells;
  for (int z = begin; z < end; ++z)
    for (int y = begin; y < end; ++y)
      for (int x = begin; x < end; ++x) cells.push_back({x, y, z});
  return cells;
}

/// Linear indices of the surface's cells in its box.
std::vector<int> cellsOf(const Json& hull) {
  std::vector<int> cells;
  int next = 0;
  for (const uint8_t gap : bytesOfBase64(hull["gaps"])) {
    next += gap;
    if (gap < 255) cells.push_back(next++);
  }
  return cells;
}

TEST(PlayerHulls, KeepTheSurfaceInTheBoxAroundIt) {
  PlayerHulls hulls;
  hulls.add(0, hullOf(0.04, block(10, 13)));
  hulls.add(1, hullOf(0.04, {}));
  const Json json = hulls.json();
  EXPECT_EQ(json[0]["size"], Json({3, 3, 3}));
  EXPECT_NEAR(json[0]["corner"][0], 1.4, 1e-12);
  EXPECT_NEAR(json[0]["corner"][2], 0.4, 1e-12);
  std::vector<int> shell;
  for (int i = 0; i < 27; ++i)
    if (i != 13) shell.push_back(i);
  EXPECT_EQ(cellsOf(json[0]), shell) << "all but the middle";
  EXPECT_EQ(json[1]["size"], Json({0, 0, 0}));
}

TEST(PlayerHulls, FarCellsComeBack) {
  PlayerHulls hulls;
  hulls.add(0, hullOf(0.04, {{0, 0, 0}, {9, 9, 2}, {9, 9, 9}}));
  // 255 and 256 cells after the one before, and many.
  hulls.add(1, hullOf(0.04, {{0, 0, 0}, {6, 5, 2}, {3, 1, 5}, {9, 9, 9}}));
  const Json json = hulls.json();
  EXPECT_EQ(cellsOf(json[0]), (std::vector<int>{0, 299, 999}));
  EXPECT_EQ(cellsOf(json[1]), (std::vector<int>{0, 256, 513, 999}));
}

TEST(PlayerHulls, SmallVoxelsAreJoined) {
  PlayerHulls hulls;
  hulls.add(0, hullOf(0.01, block(6, 12)));
  const Json json = hulls.json();
  EXPECT_NEAR(json[0]["pitch"], 0.03, 1e-12);
  EXPECT_EQ(json[0]["size"], Json({2, 2, 2}));
  EXPECT_NEAR(json[0]["corner"][1], 2.06, 1e-12);
}

}  // namespace
}  // namespace markerless_mocap
