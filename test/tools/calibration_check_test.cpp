#include "tools/offline/calibration_check.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

OrientationCorrection cameraOf(const std::string& name, double pixels, double deviation) {
  OrientationCorrection camera;
  camera.camera = name;
  camera.pixels = {pixels, 0.0};
  camera.deviation = {deviation, deviation};
  camera.turn = pixels / 600.0;
  return camera;
}

OrientationRefinement estimateOf(std::vector<OrientationCorrection> cameras) {
  OrientationRefinement estimate;
  estimate.status = OrientationRefinementStatus::kCorrected;
  estimate.corrections = std::move(cameras);
  return estimate;
}

TEST(CalibrationFinding, NamesTheCamerasWhoseRotationStandsOut) {
  const std::string text = calibrationFinding(estimateOf(
      {cameraOf("left", 5.0, 0.5), cameraOf("right", 1.0, 0.1), cameraOf("top", 8.0, 3.0)}));
  EXPECT_EQ(text,
            "the calibration looks wrong: the person fits better if these cameras are rotated: "
            "left by 0.48 degrees (5.0 px); it is used as it is. --self-calibrate corrected.yaml "
            "estimates the rotations and uses them");
}

TEST(CalibrationFinding, SmallOrUncertainRotationsAreNotMentioned) {
  OrientationCorrection long_lens = cameraOf("tele", 5.0, 0.1),
                        wide_lens = cameraOf("wide", 1.2, 0);
  long_lens.turn = 0.002;
  wide_lens.turn = 0.01;
  for (const OrientationCorrection& camera : {cameraOf("top", 8.0, 3.0), long_lens, wide_lens})
    EXPECT_EQ(calibrationFinding(estimateOf({camera})), "");
}

TEST(CalibrationFinding, ARigThatIsNotSignificantlyBetterIsNotMentioned) {
  OrientationRefinement estimate = estimateOf({cameraOf("left", 5.0, 0.5)});
  estimate.status = OrientationRefinementStatus::kNoGain;
  EXPECT_EQ(calibrationFinding(estimate), "");
}

}  // namespace
}  // namespace markerless_mocap
