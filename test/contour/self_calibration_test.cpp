#include "contour/self_calibration.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <stdexcept>

#include "contour/drawn_body.h"
#include "contour/rig_shift.h"
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

/// Cameras that are told to look past where they look, each in another direction.
CameraRig misjudged(const CameraRig& rig, double pixels) {
  CameraRig told;
  for (size_t i = 0; i < rig.size(); ++i) {
    CameraCalibration camera = rig[i].calibration();
    const double direction = 2.4 * double(i);
    const Eigen::Vector3d axis(std::cos(direction), std::sin(direction), 0.0);
    camera.T_world_camera.rotate(Eigen::AngleAxisd(pixels / camera.K(0, 0), axis));
    told.emplace_back(camera);
  }
  return told;
}

class SelfCalibrationTest : public ::testing::Test {
 protected:
  SelfCalibrationTest()
      : truth(drawnRig(6)), body(ShapeStatistics::handMade().meanShape(1.7)), told(truth) {}

  void film(const CameraRig& calibration, int count = 8) {
    told = calibration;
    const ContourObserver observer(told, options);
    for (int i = 0; i < count; ++i) {
      poses.push_back(disturbed(stride(), 0.25, 0.1, 10 + unsigned(i)));
      OrientationSample instant;
      instant.seen = observer.observe(drawnMasks(truth, body, poses.back()));
      instant.start = disturbed(poses.back(), 0.05, 0.02, 30 + unsigned(i));
      instants.push_back(std::move(instant));
    }
  }
  OrientationRefinement estimate() const {
    return refineCameraOrientations(told, options, body, instants);
  }

  CameraRig truth;
  ContourOptions options;
  ContourBody body;
  CameraRig told;
  std::vector<ContourPose> poses;
  std::vector<OrientationSample> instants;
};

TEST_F(SelfCalibrationTest, FindsHowCamerasPointRelativeToEachOther) {
  film(misjudged(truth, 3.0));
  const Eigen::VectorXd off = relative(truth, shiftBetween(truth, told));
  ASSERT_GT(off.norm() / std::sqrt(6), 2.0);
  const OrientationRefinement found = estimate();
  EXPECT_EQ(found.status, OrientationRefinementStatus::kCorrected);
  EXPECT_LT(relative(truth, shiftBetween(truth, found.rig)).cwiseAbs().maxCoeff(), 0.3);
  EXPECT_GT(found.after.overlap, found.before.overlap + 0.02);
  EXPECT_LT(found.after.distance, 0.4 * found.before.distance);
  EXPECT_EQ(found.samples_used, 8);
  ASSERT_EQ(found.corrections.size(), 6u);
  for (size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(found.corrections[c].camera, truth[c].name());
    const Eigen::Vector2d moved = shiftBetween(told, found.rig).segment<2>(Eigen::Index(2 * c));
    EXPECT_LT((moved - found.corrections[c].pixels).norm(), 0.2);
    EXPECT_GT(found.corrections[c].deviation.minCoeff(), 0.0);
    EXPECT_LT(found.corrections[c].deviation.maxCoeff(), 2.0) << "the prior's";
    EXPECT_GT(found.corrections[c].rays, 500u);
  }
  EXPECT_EQ(found.summary().rfind("the camera orientations are corrected: in 8 frames", 0), 0u)
      << found.summary();
}

TEST_F(SelfCalibrationTest, PerspectiveTellsAShiftOfAllCamerasTogether) {
  CameraRig shifted = truth;  // all cameras as if the person stood 20 mm higher
  for (Camera& camera : shifted) {
    CameraCalibration c = camera.calibration();
    const Eigen::Vector3d way = kMiddle - camera.position();
    c.T_world_camera.linear() =
        Eigen::Quaterniond::FromTwoVectors(way, way + Eigen::Vector3d(0, 0, 0.02)) *
        c.T_world_camera.linear();
    camera = Camera(c);
  }
  film(shifted);
  ASSERT_GT(shiftBetween(truth, told).norm() / std::sqrt(6), 1.2);
  ASSERT_LT(relative(truth, shiftBetween(truth, told)).norm() / std::sqrt(6), 0.1);
  const OrientationRefinement found = estimate();
  EXPECT_EQ(found.status, OrientationRefinementStatus::kCorrected);
  EXPECT_LT(shiftBetween(truth, found.rig).norm() / std::sqrt(6), 0.5);
}

TEST_F(SelfCalibrationTest, ARigThatIsRightStaysAndIsSaidTo) {
  film(truth);
  const OrientationRefinement found = estimate();
  EXPECT_EQ(found.status, OrientationRefinementStatus::kNoGain);
  for (size_t c = 0; c < truth.size(); ++c)
    EXPECT_EQ(found.rig[c].calibration().T_world_camera.matrix(),
              truth[c].calibration().T_world_camera.matrix());
  for (const OrientationCorrection& one : found.corrections) EXPECT_LT(one.pixels.norm(), 0.3);
  EXPECT_EQ(found.summary().rfind(
                "the calibration is unchanged, because no other is significantly better: ", 0),
            0u)
      << found.summary();
}

TEST_F(SelfCalibrationTest, PosesComeWithTheRig) {
  film(misjudged(truth, 3.0));
  const OrientationRefinement found = estimate();
  ASSERT_EQ(found.poses.size(), poses.size());
  // A body that is elsewhere as a whole, as contours cannot tell where it is.
  Eigen::MatrixXd off(3, poses.size());
  for (size_t i = 0; i < poses.size(); ++i)
    off.col(Eigen::Index(i)) =
        (body.points(found.poses[i]) - body.points(poses[i])).leftCols<15>().rowwise().mean();
  EXPECT_LT((off.colwise() - off.rowwise().mean()).colwise().norm().maxCoeff(), 0.004);
}

TEST_F(SelfCalibrationTest, IsTheSameOnAnyNumberOfThreads) {
  film(misjudged(truth, 2.0), 4);
  const auto on = [&](size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return estimate();
  };
  const OrientationRefinement one = on(1), two = on(2);
  for (size_t c = 0; c < one.corrections.size(); ++c)
    EXPECT_EQ(one.corrections[c].pixels, two.corrections[c].pixels);
}

TEST_F(SelfCalibrationTest, TooFewInstantsSaySo) {
  film(truth, 4);
  instants[2].seen = ContourObserver(told, options).observe(std::vector<cv::Mat>(told.size()));
  const OrientationRefinement found = estimate();
  EXPECT_EQ(found.status, OrientationRefinementStatus::kTooFewSamples);
  EXPECT_EQ(found.rig.size(), told.size());
  EXPECT_EQ(
      found.summary(),
      "the camera orientations were not estimated: only 3 frames of different postures could be "
      "fitted, at least 4 are needed");
}

TEST_F(SelfCalibrationTest, RefusesOtherRigs) {
  film(truth, 4);
  told.pop_back();
  EXPECT_EQ(errorTextOf([&] { estimate(); }),
            "contour: a sample for the refinement of camera orientations is of another rig");
}

}  // namespace
}  // namespace markerless_mocap
