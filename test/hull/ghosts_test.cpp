#include <gtest/gtest.h>

#include "hull/hull_scene.h"

namespace markerless_mocap {
namespace {

/// Four cameras far away on the axes, so that each sees nearly parallel rays.
CameraRig makeCross() {
  CameraRig rig;
  const Eigen::Vector3d places[] = {{12, 0, 0}, {0, 12, 0}, {-12, 0, 0}, {0, -12, 0}};
  for (int i = 0; i < 4; ++i)
    rig.push_back(
        makeCamera("cam" + std::to_string(i), places[i], Eigen::Vector3d::Zero(), {}, 1000));
  return rig;
}

HullOptions crossOptions() {
  HullOptions options = makeOptions();
  options.pitch = 0.02;
  return options;
}

/// Two balls at opposite corners of a square, at different heights. At the square's other corners
/// all cameras see a ball before or behind.
const std::vector<Sphere> kBalls = {{{-0.3, -0.3, -0.06}, 0.18}, {{0.3, 0.3, 0.06}, 0.14}};

TEST(Ghosts, OfTwoThingsAreFlaggedAndTheThingsAreNot) {
  const CameraRig rig = makeCross();
  const VisualHull hull = HullCarver(rig, crossOptions()).carve(renderViews(rig, kBalls));
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  ASSERT_EQ(hull.components.size(), 4u);
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(hull.components[i].suspect_ghost) << i;
  for (int i = 2; i < 4; ++i) {
    EXPECT_TRUE(hull.components[i].suspect_ghost) << i;
    EXPECT_GT(hull.components[i].litres, 5) << "as large as the things themselves";
  }
  const Eigen::Vector3d somewhere = hull.lattice.center(hull.voxels[0].index);
  EXPECT_LT(somewhere.x() + somewhere.y(), 0) << "the person is the larger ball";
}

TEST(Ghosts, AreGoneWithAFifthCamera) {
  CameraRig rig = makeCross();
  rig.push_back(makeCamera("cam4", {8, 8, 4}, Eigen::Vector3d::Zero(), {}, 1000));
  const VisualHull hull = HullCarver(rig, crossOptions()).carve(renderViews(rig, kBalls));
  for (const HullComponent& component : hull.components)
    EXPECT_TRUE(!component.suspect_ghost || component.litres < 1);
}

TEST(Ghosts, NothingIsSuspectAlone) {
  const CameraRig rig = makeCross();
  const VisualHull hull = HullCarver(rig, crossOptions()).carve(renderViews(rig, {kBalls[0]}));
  ASSERT_EQ(hull.components.size(), 1u);
  EXPECT_FALSE(hull.components[0].suspect_ghost);
}

TEST(PoorlySeen, CornerThatTwoOfManyCamerasSeeIsNotThePerson) {
  // Two cameras alone see the volume's corner, and their masks are set there.
  CameraRig rig;
  for (int i = 0; i < 8; ++i) {
    const double a = i * 0.785;
    rig.push_back(makeCamera("cam" + std::to_string(i), {3 * std::cos(a), 3 * std::sin(a), 0.1 * i},
                             {0, 0, 0.3 - 0.08 * i}, {}, 300));
  }
  rig.push_back(makeCamera("far0", {4, 4, 4}, {1.2, 1.2, 1.2}, {}, 150));
  rig.push_back(makeCamera("far1", {-2, 4, 4}, {1.2, 1.2, 1.2}, {}, 150));
  HullOptions options = makeOptions();
  options.volume_max.setConstant(1.6);
  options.leave_out_bad_cameras = false;
  std::vector<HullView> views =
      renderViews(rig, {Sphere{{0, 0, 0}, 0.25}, Sphere{{1.25, 1.25, 1.25}, 0.3}});
  const VisualHull hull = HullCarver(rig, options).carve(views);
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_LT(hull.lattice.center(hull.voxels[0].index).norm(), 0.5);
  ASSERT_GE(hull.components.size(), 2u);
  EXPECT_GT(hull.components[1].litres, hull.components[0].litres);
  EXPECT_TRUE(hull.components[1].poorly_seen);
}

TEST(PoorlySeen, WhatTwoOfFourCamerasSeeIsNoSecondBody) {
  // A cross of cameras sees the first ball; two of them alone also see where the second one is.
  CameraRig rig;
  const Eigen::Vector3d places[] = {{3, 0, 0.2}, {0, 3, 0.1}, {-3, 0, 0.3}, {0, -3, 0.15}};
  for (int i = 0; i < 4; ++i)
    rig.push_back(makeCamera("cam" + std::to_string(i), places[i], Eigen::Vector3d::Zero(), {},
                             i < 2 ? 140 : 400));
  HullOptions options = makeOptions();
  options.volume_max = {0.6, 0.6, 1.3};
  std::vector<HullView> views =
      renderViews(rig, {Sphere{{0, 0, 0}, 0.3}, Sphere{{0, 0, 0.9}, 0.25}});
  const VisualHull hull = HullCarver(rig, options).carve(views);
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  ASSERT_GE(hull.components.size(), 2u);
  EXPECT_GT(hull.components[1].litres, 15);
  EXPECT_NEAR(hull.components[1].mean_views, 2, 1e-9);
  EXPECT_TRUE(hull.components[1].poorly_seen);
}

}  // namespace
}  // namespace markerless_mocap
