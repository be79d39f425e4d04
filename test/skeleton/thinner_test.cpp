#include "skeleton/thinner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <thread>

#include "hull/hull_scene.h"
#include "skeleton/thin_figures.h"

namespace markerless_mocap {
namespace {

ThinVolume thinned(const ThinVolume& volume) {
  const CurveSkeleton skeleton = Thinner(0.0).thin(volume.lattice, volume.voxels());
  return {skeleton.lattice, skeleton.voxels};
}

std::string errorTextOf(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
  try {
    Thinner().thin(lattice, voxels);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ThinnerTest, NothingGivesNothing) {
  EXPECT_TRUE(Thinner().thin(VisualHull()).voxels.empty());
}

TEST(ThinnerTest, OneVoxelStays) {
  ThinVolume volume(9, 9, 9);
  volume.set(3, 4, 5);
  EXPECT_EQ(thinned(volume).voxels(), volume.voxels());
}

TEST(ThinnerTest, BallsAndBlocksShrinkToAPointInTheirMiddle) {
  ThinVolume ball(41, 41, 41);
  addLimb({20, 20, 20}, {20, 20, 20}, 17.3, &ball);
  EXPECT_EQ(thinned(ball).voxels(), std::vector<uint32_t>{ball.lattice.index(20, 20, 20)});
  ThinVolume block(21, 21, 21);
  block.fillWhere([](int, int, int) { return true; });
  EXPECT_EQ(thinned(block).voxels(), std::vector<uint32_t>{block.lattice.index(10, 10, 10)});
}

TEST(ThinnerTest, RodThinsToItsAxis) {
  ThinVolume rod(50, 11, 11);
  addLimb({8, 5, 5}, {41, 5, 5}, 4.2, &rod);
  const ThinVolume thin = thinned(rod);
  for (uint32_t index : thin.voxels()) {
    EXPECT_EQ(thin.lattice.coordinates(index).y(), 5);
    EXPECT_EQ(thin.lattice.coordinates(index).z(), 5);
  }
  for (int x = 10; x <= 39; ++x) EXPECT_TRUE(thin.at(x, 5, 5)) << x;
}

TEST(ThinnerTest, CurvesStayWithTheirEndsWhateverThePersistence) {
  ThinVolume curve(20, 20, 40);
  for (int i = 2; i < 38; ++i) curve.set(2 + i / 3, 10 + i % 2, i);
  for (int i = 11; i < 19; ++i) curve.set(i, 10, 20 + i);
  const ThinVolume input(curve.lattice, curve.voxels());
  const CurveSkeleton skeleton =
      Thinner(5 * curve.lattice.pitch).thin(input.lattice, input.voxels());
  const ThinVolume thin(skeleton.lattice, skeleton.voxels);
  int ends = 0;
  for (uint32_t index : input.voxels()) {
    const Eigen::Vector3i p = input.lattice.coordinates(index);
    if (input.neighborCount(p.x(), p.y(), p.z()) != 1) continue;
    EXPECT_TRUE(thin.at(p.x(), p.y(), p.z())) << p.transpose();
    ++ends;
  }
  EXPECT_EQ(ends, 3);
}

TEST(ThinnerTest, RingStaysARing) {
  ThinVolume ring(41, 41, 15);
  ring.fillWhere([](int x, int y, int z) {
    const double around = std::hypot(x - 20, y - 20) - 13;
    return std::hypot(around, z - 7) <= 4.4;
  });
  const ThinVolume thin = thinned(ring);
  EXPECT_EQ(thin.tunnels(), 1);
  for (uint32_t index : thin.voxels()) {
    const Eigen::Vector3i p = thin.lattice.coordinates(index);
    EXPECT_EQ(thin.neighborCount(p.x(), p.y(), p.z()), 2) << "no spur on it";
  }
}

TEST(ThinnerTest, PersonHasFiveEndsAndBothBranchings) {
  const ThinVolume thin = thinned(person());
  int ends = 0;
  for (uint32_t index : thin.voxels()) {
    const Eigen::Vector3i p = thin.lattice.coordinates(index);
    ends += thin.neighborCount(p.x(), p.y(), p.z()) == 1;
  }
  EXPECT_EQ(ends, 5);
  EXPECT_EQ(thin.components(), 1);
  EXPECT_EQ(thin.tunnels(), 0);
}

TEST(ThinnerTest, BumpsLeaveNoSpurUnlessTheyPersist) {
  ThinVolume body(31, 31, 60);
  addLimb({15, 15, 9}, {15, 15, 50}, 8.2, &body);
  addLimb({15, 15, 30}, {26, 15, 30}, 1.1, &body);  // stands out by three voxels
  body.lattice.pitch = 0.01;
  const auto ends = [&](double persistence) {
    const CurveSkeleton skeleton = Thinner(persistence).thin(body.lattice, body.voxels());
    const ThinVolume thin(skeleton.lattice, skeleton.voxels);
    return std::count_if(skeleton.voxels.begin(), skeleton.voxels.end(), [&](uint32_t index) {
      const Eigen::Vector3i p = thin.lattice.coordinates(index);
      return thin.neighborCount(p.x(), p.y(), p.z()) == 1;
    });
  };
  EXPECT_EQ(ends(0.0), 3);
  EXPECT_EQ(ends(0.04), 2);
}

TEST(ThinnerTest, LargestComponentStaysAndTheOthersAreTold) {
  ThinVolume volume(40, 12, 12);
  addLimb({4, 5, 5}, {20, 5, 5}, 2.5, &volume);
  addLimb({30, 5, 5}, {34, 5, 5}, 2.5, &volume);
  volume.set(39, 11, 11);
  const size_t before = volume.voxels().size();
  ThinVolume kept(40, 12, 12);
  addLimb({4, 5, 5}, {20, 5, 5}, 2.5, &kept);
  const CurveSkeleton skeleton = Thinner().thin(volume.lattice, volume.voxels());
  EXPECT_EQ(skeleton.components_dropped, 2u);
  EXPECT_EQ(skeleton.voxels_dropped, before - kept.voxels().size());
  EXPECT_EQ(skeleton.voxels, Thinner().thin(kept.lattice, kept.voxels()).voxels);
}

TEST(ThinnerTest, CavitiesAreFilledAndTold) {
  ThinVolume volume(30, 15, 15);
  addLimb({7, 7, 7}, {22, 7, 7}, 5.4, &volume);
  const std::vector<uint32_t> solid = Thinner().thin(volume.lattice, volume.voxels()).voxels;
  volume.set(10, 7, 7, false);
  for (int x = 14; x < 20; ++x) volume.set(x, 6, 8, false);
  const CurveSkeleton skeleton = Thinner().thin(volume.lattice, volume.voxels());
  EXPECT_EQ(skeleton.voxels_filled, 7u);
  EXPECT_EQ(skeleton.voxels, solid);
}

TEST(ThinnerTest, PlaceInTheLatticeDoesNotMatter) {
  const ThinVolume figure = person();
  const CurveSkeleton skeleton = Thinner().thin(figure.lattice, figure.voxels());
  ThinVolume moved(200, 90, 100);
  moved.fillWhere([&](int x, int y, int z) { return figure.at(x - 101, y - 33, z - 9); });
  std::vector<uint32_t> expected;
  for (uint32_t index : skeleton.voxels) {
    const Eigen::Vector3i p = skeleton.lattice.coordinates(index);
    expected.push_back(moved.lattice.index(p.x() + 101, p.y() + 33, p.z() + 9));
  }
  EXPECT_EQ(Thinner().thin(moved.lattice, moved.voxels()).voxels, expected);
}

TEST(ThinnerTest, MirroredPersonGetsTheMirroredSkeletonWithinAVoxel) {
  const ThinVolume figure = person(), thin = thinned(figure);
  EXPECT_EQ(mirrored(figure, 0).voxels(), figure.voxels()) << "the person is symmetric";
  EXPECT_LE(distance(thin, mirrored(thin, 0)), 1);
  for (int axis : {1, 2})
    EXPECT_LE(distance(thinned(mirrored(figure, axis)), mirrored(thin, axis)), 1);
}

/// Balls for the trunk, a head and four limbs, seen by five cameras, so that the hull has the edges
/// and bulges of a real one.
VisualHull carvedPerson() {
  std::vector<Sphere> balls = {{{0, 0, 0.05}, 0.15}, {{0, 0, -0.08}, 0.14}, {{0, 0, 0.38}, 0.1}};
  for (int i = 0; i < 8; ++i) {
    const double t = i / 7.0;
    balls.push_back({{0.02, 0.12 + 0.4 * t, 0.16 + 0.1 * t}, 0.055});
    balls.push_back({{0.25 * t, -0.12 - 0.3 * t, 0.16 + 0.2 * t}, 0.055});
    balls.push_back({{0.1 * t, 0.08 + 0.1 * t, -0.16 - 0.36 * t}, 0.07});
    balls.push_back({{-0.1 * t, -0.08 - 0.1 * t, -0.16 - 0.36 * t}, 0.07});
  }
  HullOptions options = makeOptions();
  options.pitch = 0.016;
  const CameraRig rig = makeRig(5);
  return HullCarver(rig, options).carve(renderViews(rig, balls));
}

TEST(ThinnerTest, CarvedHullKeepsItsTunnelsAndThreadsDoNotMatter) {
  const VisualHull hull = carvedPerson();
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  const CurveSkeleton skeleton = Thinner().thin(hull);
  const ThinVolume before(hull.lattice, indices(hull)), after(skeleton.lattice, skeleton.voxels);
  ASSERT_EQ(skeleton.components_dropped, 0u);
  EXPECT_EQ(after.tunnels(), before.tunnels());
  EXPECT_EQ(after.components(), 1);
  EXPECT_GT(skeleton.voxels.size(), 60u);
  EXPECT_LT(skeleton.voxels.size(), 300u);

  std::vector<CurveSkeleton> results(6);
  std::vector<std::thread> threads;
  for (CurveSkeleton& result : results)
    threads.emplace_back([&] {
      Thinner thinner;
      thinner.thin(person().lattice, person().voxels());  // what was there before leaves nothing
      result = thinner.thin(hull);
    });
  for (std::thread& thread : threads) thread.join();
  for (const CurveSkeleton& result : results) EXPECT_EQ(result.voxels, skeleton.voxels);
}

TEST(ThinnerTest, MillionVoxelsAreThinned) {
  ThinVolume block(100, 100, 100);
  block.fillWhere([](int x, int y, int z) { return (x / 5 + y / 7 + z / 9) % 11 != 0; });
  const CurveSkeleton skeleton = Thinner().thin(block.lattice, block.voxels());
  EXPECT_FALSE(skeleton.voxels.empty());
  EXPECT_LT(skeleton.voxels.size(), block.voxels().size() / 4);
}

TEST(ThinnerTest, BadInputIsNamed) {
  VoxelLattice lattice;
  lattice.size = {4, 4, 4};
  EXPECT_EQ(errorTextOf(lattice, {3, 64}), "voxel 64 is beyond the lattice of 64");
  EXPECT_EQ(errorTextOf(lattice, {3, 2}), "voxels must be in ascending order, each once");
  EXPECT_EQ(errorTextOf(lattice, {3, 3}), "voxels must be in ascending order, each once");
  EXPECT_THROW(Thinner(-0.01), std::invalid_argument);
  EXPECT_THROW(Thinner(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(Thinner(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
