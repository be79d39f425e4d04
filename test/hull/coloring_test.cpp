#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "hull/color/surface_visibility.h"
#include "hull/hull_scene.h"

namespace markerless_mocap {
namespace {

using Rgb = std::array<uint8_t, 3>;

/// Six cameras around the origin, at its height; the first one on the x axis.
CameraRig makeHorizontalRig() {
  CameraRig rig;
  for (int i = 0; i < 6; ++i)
    rig.push_back(makeCamera("cam" + std::to_string(i),
                             {3 * std::cos(i * M_PI / 3), 3 * std::sin(i * M_PI / 3), 0},
                             Eigen::Vector3d::Zero()));
  return rig;
}

cv::Mat flat(cv::Scalar bgr) {
  return cv::Mat(120, 160, CV_8UC3, bgr);
}

/// The voxel of the hull that reaches furthest in a direction.
const HullVoxel& furthest(const VisualHull& hull, const Eigen::Vector3d& direction) {
  return *std::max_element(hull.voxels.begin(), hull.voxels.end(),
                           [&](const HullVoxel& a, const HullVoxel& b) {
                             return hull.lattice.center(a.index).dot(direction) <
                                    hull.lattice.center(b.index).dot(direction);
                           });
}

TEST(HullColors, CamerasColorOnlyWhatTheyFace) {
  const CameraRig rig = makeHorizontalRig();
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  views[0].image = flat({0, 0, 200});
  views[3].image = flat({200, 0, 0});
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(views);
  EXPECT_EQ(furthest(hull, Eigen::Vector3d::UnitX()).rgb, (Rgb{200, 0, 0}));
  EXPECT_EQ(furthest(hull, -Eigen::Vector3d::UnitX()).rgb, (Rgb{0, 0, 200}));
}

TEST(HullColors, MeanIsRgbOfTheCamerasThatSeeTheVoxel) {
  const CameraRig rig = makeHorizontalRig();
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  views[0].image = flat({30, 20, 10});
  views[1].image = cv::Mat(120, 160, CV_8UC1, cv::Scalar(40));
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(views);
  const Eigen::Vector3d between(std::cos(M_PI / 6), std::sin(M_PI / 6), 0);
  EXPECT_EQ(furthest(hull, between).rgb, (Rgb{25, 30, 35}));
}

/// Two upright plates across the x axis on a common floor, one before the other.
VoxelComponent plates(const VoxelLattice& lattice) {
  std::vector<BrickVoxels> cells;
  const auto add = [&](int i, int j, int k) {
    const Eigen::Vector3i brick = Eigen::Vector3i(i, j, k) / kBrickSide, size = bricksOf(lattice);
    cells.push_back({uint32_t((brick.z() * size.y() + brick.y()) * size.x() + brick.x()),
                     uint64_t(1) << (i % 4 + 4 * (j % 4) + 16 * (k % 4))});
  };
  for (int j = 0; j < 32; ++j) {
    for (int k = 4; k < 30; ++k) add(6, j, k);
    for (int i = 0; i < 32; ++i) add(i, j, 3);
  }
  for (int j = 10; j < 22; ++j)
    for (int k = 4; k < 16; ++k) add(26, j, k);
  return unionOf(cells);
}

TEST(SurfaceVisibility, SeesAroundWhatStandsBeforeAndNotThrough) {
  VoxelLattice lattice;
  lattice.origin = {-0.64, -0.64, -0.64};
  lattice.pitch = 0.04;
  lattice.size = {32, 32, 32};
  const CameraRig rig = {makeCamera("front", {3, 0, 0}, Eigen::Vector3d::Zero()),
                         makeCamera("back", {-3, 0, 0}, Eigen::Vector3d::Zero())};
  const ProjectionTable table(rig, lattice);
  SurfaceVisibility sight(rig, table);
  const VoxelComponent component = plates(lattice);
  sight.set(component);
  SurfaceView view;
  sight.findVisible(0, flat({0, 0, 0}), &view);
  std::vector<bool> seen(lattice.count());
  int seen_on_wall = 0;
  for (const ComponentVoxel& voxel : inLatticeOrder(component, lattice))
    seen[voxel.index] = view.seen[voxel.slot / 64] >> voxel.slot % 64 & 1;
  for (int j = 2; j < 30; ++j)
    for (int k = 5; k < 29; ++k) {
      // Where the ray to the wall passes the plane of the plate before it, in voxels.
      const double fraction = (3 - lattice.center(lattice.index(26, j, k)).x()) /
                              (3 - lattice.center(lattice.index(6, j, k)).x());
      const Eigen::Vector3d wall = lattice.center(lattice.index(6, j, k));
      const double y = (fraction * wall.y() + 0.64) / 0.04, z = (fraction * wall.z() + 0.64) / 0.04;
      const double outside = std::max({10 - y, y - 22, z - 16});
      if (outside < -1) {
        EXPECT_FALSE(seen[lattice.index(6, j, k)]) << j << " " << k;
      } else if (outside > 2) {
        EXPECT_TRUE(seen[lattice.index(6, j, k)]) << j << " " << k;
        ++seen_on_wall;
      }
    }
  EXPECT_GT(seen_on_wall, 100);
  EXPECT_TRUE(seen[lattice.index(26, 15, 10)]);
}

// Hsiao 2008, 3.1.4.2 A-1: each voxel is projected into all images.
TEST(HullColors, AllCamerasVoteInsideTheBodyAndBehindItIfAsked) {
  const CameraRig rig = makeHorizontalRig();
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  for (HullView& view : views) view.image = flat({10, 20, 30});
  views[0].image.colRange(80, 160).setTo(cv::Scalar(200, 20, 30));
  HullOptions options = makeOptions();
  const VisualHull visible = HullCarver(rig, options).carve(views);
  options.color_voters = "all";
  const VisualHull all = HullCarver(rig, options).carve(views);
  ASSERT_EQ(all.voxels.size(), visible.voxels.size());
  size_t split = 0;
  for (size_t v = 0; v < all.voxels.size(); ++v) {
    EXPECT_EQ(all.voxels[v].rgb, visible.voxels[v].rgb);
    for (int axis = 0; axis < 3; ++axis) {
      const ColorVotes& votes = all.voxels[v].color_votes;
      ASSERT_GE(votes.possible[axis], visible.voxels[v].color_votes.possible[axis]);
      if (votes.possible[axis] == 0) continue;  // no neighbour
      ASSERT_EQ(votes.possible[axis], rig.size());
      ASSERT_GE(votes.votes[axis], rig.size() - 1);
      split += votes.votes[axis] == rig.size() - 1;
    }
  }
  EXPECT_GT(split, 10u);  // across the line between the colours in the first image
}

TEST(HullColors, GreyAndNoVotesWithoutImages) {
  const CameraRig rig = makeHorizontalRig();
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(renderViews(rig, {Sphere()}));
  for (const HullVoxel& voxel : hull.voxels) {
    ASSERT_EQ(voxel.rgb, (Rgb{128, 128, 128}));
    ASSERT_EQ(voxel.color_votes.possible, (std::array<uint8_t, 3>{0, 0, 0}));
  }
}

TEST(HullColors, VotesAreLostAcrossAnEdgeOfColorOnly) {
  const CameraRig rig = makeHorizontalRig();
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  for (HullView& view : views) {  // RGB distance 41: just above the default of 40
    view.image = flat({0, 0, 41});
    view.image.rowRange(60, 120).setTo(cv::Scalar(0, 0, 0));
  }
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(views);
  const int middle = hull.lattice.size.z() / 2;
  int asked = 0, lost = 0;
  for (const HullVoxel& voxel : hull.voxels)
    for (int axis = 0; axis < 3; ++axis) {
      const int z = hull.lattice.coordinates(voxel.index).z();
      // The cameras' middle row lies between the two middle layers.
      const bool crosses = axis == 2 && z + 1 == middle;
      const ColorVotes& votes = voxel.color_votes;
      ASSERT_LE(votes.possible[axis], 3) << "cameras opposite each other see no voxel in common";
      ASSERT_EQ(votes.votes[axis], crosses ? 0 : votes.possible[axis]);
      asked += votes.possible[axis];
      lost += crosses ? votes.possible[axis] : 0;
    }
  EXPECT_GT(asked, 1000);
  EXPECT_GT(lost, 50);
}

TEST(HullColors, InsideNobodyVotes) {
  const CameraRig rig = makeHorizontalRig();
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  for (HullView& view : views) view.image = flat({0, 0, 0});
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(views);
  for (const HullVoxel& voxel : hull.voxels)
    if (hull.lattice.center(voxel.index).norm() < 0.3) {
      ASSERT_EQ(voxel.color_votes.possible, (std::array<uint8_t, 3>{0, 0, 0}));
    }
}

}  // namespace
}  // namespace markerless_mocap
