#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "hull/hull_scene.h"

namespace markerless_mocap {
namespace {

/// Eight cameras around the origin, 1.2 m above the floor, that look down a little.
CameraRig makeRoom() {
  CameraRig rig;
  for (int i = 0; i < 8; ++i)
    rig.push_back(makeCamera("cam" + std::to_string(i),
                             {3 * std::cos(i * M_PI / 4), 3 * std::sin(i * M_PI / 4), 1.2},
                             {0, 0, 0.8}));
  return rig;
}

TEST(KnownVolumes, ErrorOfASphereShrinksWithThePitch) {
  const CameraRig rig = makeRig(32);
  const std::vector<HullView> views = renderViews(rig, {Sphere()});
  const double litres = 4.0 / 3 * M_PI * 4 * 4 * 4;
  std::vector<double> errors;
  for (const double pitch : {0.16, 0.04, 0.015}) {
    HullOptions options = makeOptions();
    options.pitch = pitch;
    errors.push_back(std::abs(HullCarver(rig, options).carve(views).litres() - litres) / litres);
  }
  EXPECT_LT(errors[1], errors[0]);
  EXPECT_LT(errors[2], 0.03) << "what is left is the hull of 32 views and the pixels";
}

/// A camera far away that sees everything nearly in parallel.
Camera farCamera(const std::string& name, const Eigen::Vector3d& direction) {
  return makeCamera(name, 50 * direction, Eigen::Vector3d::Zero(), {}, 3500);
}

TEST(KnownVolumes, ErrorOfABoxShrinksWithThePitch) {
  // Seen along the axes from far away, a box is three rectangles, and its hull is the box.
  const CameraRig rig = {farCamera("x", Eigen::Vector3d::UnitX()),
                         farCamera("y", Eigen::Vector3d::UnitY()),
                         farCamera("z", Eigen::Vector3d::UnitZ())};
  const Eigen::Vector3d half(0.41, 0.27, 0.33);
  std::vector<HullView> views(3);
  for (size_t c = 0; c < 3; ++c) {
    views[c].mask = cv::Mat::zeros(120, 160, CV_8UC1);
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        const Eigen::Vector3d ray = rig[c].rayDirection(Eigen::Vector2d(x, y));
        Eigen::Vector3d at = rig[c].position() - ray * rig[c].position()[int(c)] / ray[int(c)];
        at[int(c)] = 0;
        views[c].mask.at<uint8_t>(y, x) = (at.cwiseAbs().array() < half.array()).all() ? 255 : 0;
      }
  }
  const double litres = 8 * half.prod() * 1000;
  std::vector<double> errors;
  for (const double pitch : {0.17, 0.05, 0.012}) {
    HullOptions options = makeOptions();
    options.pitch = pitch;
    const VisualHull hull = HullCarver(rig, options).carve(views);
    ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
    errors.push_back(std::abs(hull.litres() - litres) / litres);
  }
  EXPECT_LT(errors[1], errors[0]);
  EXPECT_LT(errors[2], errors[1]);
  EXPECT_LT(errors[2], 0.05);
}

TEST(CutAtFloor, TakesOffWhatTheFloorMirrors) {
  const CameraRig rig = makeRoom();
  HullOptions options = makeOptions();
  options.volume_max.z() = 1.2;
  const double upright = 0.35;
  // A ball that stands on the floor, and its mirror image below.
  std::vector<HullView> views =
      renderViews(rig, {Sphere{{0, 0, upright}, upright}, Sphere{{0, 0, -upright}, upright}});
  const auto lowest = [&] {
    const VisualHull hull = HullCarver(rig, options).carve(views);
    return hull.lattice.center(hull.voxels.front().index).z();
  };
  EXPECT_LT(lowest(), -0.3);
  options.cut_at_floor = true;
  EXPECT_GT(lowest(), 0);
  EXPECT_LT(lowest(), options.pitch);
  options.floor_height = 0.2;
  EXPECT_GT(lowest(), 0.2);
}

TEST(AutomaticVolume, IsWhatMostCamerasSeeAboveTheFloor) {
  const CameraRig rig = makeRoom();
  HullOptions options;
  options.volume = "auto";
  const VoxelLattice lattice = options.lattice(rig);
  const Eigen::Vector3d high = lattice.origin + lattice.pitch * lattice.size.cast<double>();
  EXPECT_NEAR(lattice.origin.z(), 0, lattice.pitch);
  EXPECT_GT(high.z(), 1.5);
  EXPECT_LT(high.z(), 2.7);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_LT(lattice.origin[axis], -0.5);
    EXPECT_GT(high[axis], 0.5);
    EXPECT_LT(high[axis], 3) << "not beyond the cameras";
  }
  const std::vector<Sphere> ball = {Sphere{{0.1, 0, 0.8}, 0.3}};
  const VisualHull hull = HullCarver(rig, options).carve(renderViews(rig, ball));
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_NEAR(hull.lattice.center(hull.voxels[hull.voxels.size() / 2].index).z(), 0.8, 0.05);
}

TEST(AutomaticVolume, KeepsThePlacesOfVoxelsWhenTheRigChanges) {
  CameraRig rig = makeRoom();
  HullOptions options;
  options.volume = "auto";
  const VoxelLattice all = options.lattice(rig);
  rig.erase(rig.begin() + 2, rig.begin() + 4);
  const VoxelLattice fewer = options.lattice(rig);
  const Eigen::Vector3d shift = (all.origin - fewer.origin) / all.pitch;
  EXPECT_LT((shift.array() - shift.array().round()).abs().maxCoeff(), 1e-9);
}

TEST(AutomaticVolume, CamerasThatSeeNothingInCommonAreRefused) {
  const CameraRig rig = {makeCamera("a", {0, 0, 1}, {5, 0, 1}),
                         makeCamera("b", {0, 0, 1}, {-5, 0, 1})};
  HullOptions options;
  options.volume = "auto";
  try {
    HullCarver(rig, options);
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "visual_hull/volume is auto, but most of the cameras see no place above the floor in "
              "common: give volume_min and volume_max");
  }
}

TEST(Follow, PersonWhoWalksKeepsTheSameVoxelsAsWithout) {
  const CameraRig rig = makeRig(8);
  HullOptions options = makeOptions();
  HullCarver whole(rig, options);
  options.follow = true;
  options.follow_margin = 0.15;
  HullCarver following(rig, options);
  for (int step = 0; step < 6; ++step) {
    const Sphere ball{{-0.3 + 0.1 * step, 0, 0}, 0.2};
    const std::vector<HullView> views = renderViews(rig, {ball});
    const VisualHull hull = following.carve(views);
    ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
    EXPECT_EQ(indices(hull), indices(whole.carve(views))) << step;
    EXPECT_EQ(hull.lattice, whole.lattice());
  }
}

TEST(Follow, WhatStandsFarFromThePersonIsNotLookedAt) {
  const CameraRig rig = makeRig(16);
  HullOptions options = makeOptions();
  options.follow = true;
  options.follow_margin = 0.1;
  HullCarver carver(rig, options);
  const Sphere person{{-0.3, 0, 0}, 0.22}, other{{0.35, 0, 0}, 0.22};
  ASSERT_EQ(carver.carve(renderViews(rig, {person})).status, HullStatus::kOk);
  const VisualHull hull = carver.carve(renderViews(rig, {person, other}));
  EXPECT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_LT(hull.lattice.center(hull.voxels[0].index).x(), 0);
  // Gone, and the other one is found in the whole volume at once.
  const VisualHull next = carver.carve(renderViews(rig, {other}));
  ASSERT_EQ(next.status, HullStatus::kOk) << next.reason;
  EXPECT_GT(next.lattice.center(next.voxels[0].index).x(), 0);
}

}  // namespace
}  // namespace markerless_mocap
