#include "segmentation/limbs/extremity_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "voxel_figure.h"

namespace markerless_mocap {
namespace {

/// Distance of the nearest extremity from a point, metres.
double nearestExtremity(const VoxelGraph& voxels, const std::vector<uint32_t>& extremities,
                        const Eigen::Vector3d& place) {
  double nearest = 1e9;
  for (const uint32_t extremity : extremities) {
    nearest = std::min(nearest, (voxels.centers[extremity] - place).norm());
  }
  return nearest;
}

// At 15 mm the figure has more nodes than are embedded one by one.
TEST(ExtremitySearch, FindsHandsFeetAndHeadAtAnyPitch) {
  const double angle = 1.0;
  for (const double pitch : {0.03, 0.015}) {
    const VoxelGraph voxels = buildVoxelGraph(standingFigure(angle, pitch).hull());
    const std::vector<uint32_t> extremities =
        findExtremities(voxels, coreNodes(voxels.depth, 0.85), 10, 5);
    ASSERT_EQ(extremities.size(), 5u);
    EXPECT_LT(nearestExtremity(voxels, extremities, {0.0, 0.0, 1.74}), 0.08) << pitch;
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d hand(side * (0.21 + 0.73 * std::sin(angle)), 0.0,
                                 1.38 - 0.73 * std::cos(angle));
      EXPECT_LT(nearestExtremity(voxels, extremities, hand), 0.06) << pitch;
      EXPECT_LT(nearestExtremity(voxels, extremities, {side * 0.18, 0.16, 0.02}), 0.08) << pitch;
    }
  }
}

TEST(ExtremitySearch, FindsNoMoreThanThereAre) {
  VoxelFigure ball;
  ball.capsule({0, 0, 0.5}, {0, 0, 0.5}, 0.06);
  const VoxelGraph voxels = buildVoxelGraph(ball.hull());
  const std::vector<uint32_t> extremities =
      findExtremities(voxels, coreNodes(voxels.depth, 0.85), 10, 50);
  EXPECT_GE(extremities.size(), 1u);
  EXPECT_LT(extremities.size(), 20u);
}

}  // namespace
}  // namespace markerless_mocap
