#include "nodes/visual_hull/live_carver.h"

#include <gtest/gtest.h>

#include <thread>

#include "hull/hull_scene.h"

namespace markerless_mocap {
namespace {

HullOptions automaticVolume() {
  HullOptions options;
  options.volume = "auto";
  options.floor_height = -1.0;
  return options;
}

/// Cameras around a point `x` m from the origin: their automatic volume is around it, too.
CameraRig rigAround(double x) {
  CameraRig rig;
  for (const Camera& camera : makeRig(4)) {
    CameraCalibration calibration = camera.calibration();
    calibration.T_world_camera.translation().x() += x;
    rig.emplace_back(calibration);
  }
  return rig;
}

void takeAll(LiveCarver* carver) {
  while (carver->nextRig()) {
    carver->takeNew();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

double middleOf(const LiveCarver& carver) {
  return carver.volume().center().x();
}

TEST(LiveCarver, WorksWithTheNewestOfSeveralRigs) {
  LiveCarver carver(automaticVolume());
  carver.make(rigAround(0.0));
  EXPECT_NEAR(middleOf(carver), 0.0, 0.5);
  for (const double x : {2.0, 4.0, 6.0}) carver.changeRig(rigAround(x));
  EXPECT_NEAR(middleOf(carver), 0.0, 0.5) << "the old one works until the new one is made";
  takeAll(&carver);
  EXPECT_NEAR(middleOf(carver), 6.0, 0.5);
}

TEST(LiveCarver, ARigThatIsForgottenIsNotTakenLater) {
  LiveCarver carver(automaticVolume());
  carver.make(rigAround(0.0));
  carver.changeRig(rigAround(2.0));
  carver.forgetRig();
  EXPECT_FALSE(carver);
  carver.make(rigAround(4.0));
  carver.changeRig(rigAround(6.0));
  takeAll(&carver);
  EXPECT_NEAR(middleOf(carver), 6.0, 0.5);
}

}  // namespace
}  // namespace markerless_mocap
