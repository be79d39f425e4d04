#include "calibration/walk_floor.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "capture/studio_fixture.h"
#include "capture/virtual_studio.h"
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

constexpr double kDegree = M_PI / 180;

/// A walk in the studio, in a world that lies askew.
struct Walk {
  Eigen::Isometry3d askew = Eigen::Isometry3d::Identity();  ///< from the true world
  CameraRig cameras;
  std::vector<SilhouetteSet> frame_sets;
  double stature = 0.0;

  Walk(const StudioOptions& options, const Eigen::AngleAxisd& turn) {
    askew.linear() = turn.toRotationMatrix();
    askew.translation() << 0.4, -1.3, 2.1;
    const VirtualStudio studio(options, packageFiles(), "person1");
    stature = studio.stature();
    for (const Camera& camera : studio.trueRig()) {
      CameraCalibration calibration = camera.calibration();
      calibration.T_world_camera = askew * calibration.T_world_camera;
      cameras.emplace_back(calibration);
    }
    for (int i = 0; i < studio.frameSetCount(); ++i)
      frame_sets.push_back(studio.render(i).silhouettes);
  }

  /// Where the found world lies in the true one.
  Eigen::Isometry3d found(const WalkFloor& floor) const {
    return (floor.new_old * askew).inverse();
  }
};

StudioOptions walkInCircle(const std::string& rig) {
  StudioOptions options;
  options.motion = "walk_in_circle";
  options.rig = rig;
  options.background_frames = 0;
  options.fps = 3;
  options.duration = 9;
  return options;
}

double tiltOf(const Eigen::Isometry3d& found) {
  return std::acos(std::min(1.0, found.linear()(2, 2)));
}

double heightOf(const Eigen::Isometry3d& found) {
  return found.translation().z();
}

TEST(FloorFromWalk, FloorAndUpAreFoundHoweverTheWorldLies) {
  for (const double turn : {0.0, 2.1}) {
    const Walk walk(walkInCircle("ring4"),
                    Eigen::AngleAxisd(turn, Eigen::Vector3d(1, 0.4, -0.2).normalized()));
    const WalkFloor floor = floorFromWalk(walk.cameras, walk.frame_sets);
    const Eigen::Isometry3d found = walk.found(floor);
    EXPECT_LT(tiltOf(found), 0.4 * kDegree) << turn;
    EXPECT_NEAR(heightOf(found), 0.0, 0.008) << turn;
    EXPECT_NEAR(floor.extent, 2.15, 0.2);
    EXPECT_NEAR(floor.stature, walk.stature, 0.06);
    EXPECT_LT(floor.tilt_sigma, 0.5 * kDegree);
    // The origin is amid the circle, and x stays where it was, but for what up asks.
    EXPECT_LT(found.translation().norm(), 0.5);
    EXPECT_GT(floor.new_old.linear()(0, 0), 0.3);
  }
}

/// Cameras that hang upside down: their images say that the floor is above.
TEST(FloorFromWalk, TheEndThatStandsStillIsBelowWhateverTheCamerasSay) {
  Walk walk(walkInCircle("ring4"), Eigen::AngleAxisd::Identity());
  for (Camera& camera : walk.cameras) {
    CameraCalibration calibration = camera.calibration();
    calibration.T_world_camera.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()));
    calibration.K(0, 2) = calibration.width - 1 - calibration.K(0, 2);
    calibration.K(1, 2) = calibration.height - 1 - calibration.K(1, 2);
    camera = Camera(calibration);
  }
  for (SilhouetteSet& set : walk.frame_sets)
    for (cv::Mat& silhouette : set) cv::rotate(silhouette, silhouette, cv::ROTATE_180);
  EXPECT_LT(tiltOf(walk.found(floorFromWalk(walk.cameras, walk.frame_sets))), 0.4 * kDegree);
}

TEST(FloorFromWalk, APersonOnOneSpotTellsUpOnlyRoughlyAndThatIsSaid) {
  StudioOptions options = walkInCircle("ring8");
  options.motion = "wave";
  const Walk walk(options, Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 0.4, -0.2).normalized()));
  const WalkFloor floor = floorFromWalk(walk.cameras, walk.frame_sets);
  EXPECT_LT(floor.extent, 0.1);
  EXPECT_GT(floor.tilt_sigma, 2 * kDegree);
  EXPECT_LT(tiltOf(walk.found(floor)), 2 * floor.tilt_sigma);
}

TEST(FloorFromWalk, WhatIsMissingIsTold) {
  Walk walk(walkInCircle("ring4"), Eigen::AngleAxisd::Identity());
  for (SilhouetteSet& set : walk.frame_sets)
    for (size_t i = 1; i < set.size(); ++i) set[i].release();
  EXPECT_EQ(errorTextOf([&] { floorFromWalk(walk.cameras, walk.frame_sets); }),
            "a person who stands or walks is seen in 0 of 27 frame sets, the floor needs at least "
            "10: is the person seen whole by most cameras, and is everything else still?");
}

}  // namespace
}  // namespace markerless_mocap
