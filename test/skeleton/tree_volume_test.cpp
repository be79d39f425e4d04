#include "skeleton/graph/tree_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace markerless_mocap {
namespace {

VisualHull hullOf(const std::set<uint32_t>& voxels, const Eigen::Vector3i& size) {
  VisualHull hull;
  hull.lattice.origin = {-1.0, 0.5, 0.0};
  hull.lattice.pitch = 0.1;
  hull.lattice.size = size;
  for (const uint32_t index : voxels) {
    hull.voxels.emplace_back();
    hull.voxels.back().index = index;
  }
  return hull;
}

TEST(TreeVolume, HoldsTheVoxelsOfTheHullAndNoOthers) {
  std::mt19937 random(3);
  const Eigen::Vector3i size(71, 5, 4);  // rows longer than a word
  for (const double fraction : {0.02, 0.5, 0.9, 1.0}) {
    std::set<uint32_t> voxels;
    for (uint32_t i = 0; i < uint32_t(size.prod()); ++i)
      if (std::generate_canonical<double, 32>(random) < fraction) voxels.insert(i);
    const VisualHull hull = hullOf(voxels, size);
    const TreeVolume volume(hull);
    for (int z = -1; z <= size.z(); ++z)
      for (int y = -1; y <= size.y(); ++y)
        for (int x = -1; x <= size.x(); ++x) {
          const bool outside =
              x < 0 || y < 0 || z < 0 || x == size.x() || y == size.y() || z == size.z();
          EXPECT_EQ(volume.inside({x, y, z}),
                    !outside && voxels.count(hull.lattice.index(x, y, z)) > 0)
              << x << ' ' << y << ' ' << z << " at " << fraction;
        }
  }
}

TEST(TreeVolume, EmptyHullHoldsNothing) {
  EXPECT_FALSE(TreeVolume(hullOf({}, {4, 4, 4})).inside({0, 0, 0}));
}

TEST(TreeVolume, ThicknessIsTheWayOut) {
  std::set<uint32_t> slab;  // seven voxels thick along y
  const Eigen::Vector3i size(21, 7, 21);
  for (uint32_t i = 0; i < uint32_t(size.prod()); ++i) slab.insert(i);
  const TreeVolume volume(hullOf(slab, size));
  EXPECT_NEAR(volume.thickness(Eigen::Vector3i(10, 3, 10)), 0.35, 1e-9);
  EXPECT_NEAR(volume.thickness(Eigen::Vector3i(10, 0, 10)), 0.05, 1e-9);
  EXPECT_NEAR(volume.thickness(Eigen::Vector3d(0.05, 0.85, 1.05)), 0.35, 1e-9);
}

}  // namespace
}  // namespace markerless_mocap
