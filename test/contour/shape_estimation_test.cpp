#include "contour/shape_estimation.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <stdexcept>

#include "contour/drawn_body.h"
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

class SizeEstimatorTest : public ::testing::Test {
 protected:
  SizeEstimatorTest() : rig(drawnRig(6)) {
    prior.shape_statistics = ShapeStatistics::handMade();
    prior.stature = 1.75;
    truth = prior.shape_statistics.meanShape(1.68);
    truth[BodyLength::kThigh] *= 1.05;
    truth[BodyLength::kForearm] *= 0.93;
    truth[radiusIndex(BodyCone::kChest, 1)] *= 1.2;
    truth[radiusIndex(BodyCone::kThigh, 0)] *= 1.15;
    const ContourBody body(truth);
    const ContourObserver observer(rig, options);
    for (unsigned i = 0; i < 6; ++i) {
      poses.push_back(disturbed(stride(), 0.25, 0.1, 10 + i));
      ShapeSample instant;
      instant.seen = observer.observe(drawnMasks(rig, body, poses.back()));
      instant.start = disturbed(poses.back(), 0.05, 0.02, 30 + i);
      instants.push_back(std::move(instant));
    }
  }
  ShapeEstimate estimate() const {
    return estimateShape(rig, options, prior, prior.shape_statistics.meanShape(prior.stature),
                         instants);
  }

  CameraRig rig;
  ContourOptions options;
  ShapePrior prior;
  ShapeParameters truth;
  std::vector<ContourPose> poses;
  std::vector<ShapeSample> instants;
};

TEST_F(SizeEstimatorTest, FindsLengthsRadiiAndStatureTogether) {
  const ShapeEstimate found = estimate();
  EXPECT_EQ(found.samples_used, 6);
  EXPECT_NEAR(found.stature, 1.68, 0.03);
  for (const int size : {int(BodyLength::kThigh), int(BodyLength::kForearm),
                         int(BodyLength::kUpperArm), int(BodyLength::kTorso)})
    EXPECT_NEAR(found.shape[size], truth[size], 0.015) << shapeParameterName(size);
  for (const int size : {radiusIndex(BodyCone::kChest, 1), radiusIndex(BodyCone::kThigh, 0)})
    EXPECT_NEAR(found.shape[size], truth[size], 0.006) << shapeParameterName(size);
  const ContourBody body(truth), fitted(found.shape);
  for (size_t i = 0; i < poses.size(); ++i)
    EXPECT_LT(jointDistance(body, poses[i], fitted, found.poses[i]), 0.015);
  EXPECT_GT(found.deviation[BodyLength::kThigh], 0);
  EXPECT_LT(found.deviation[BodyLength::kThigh], 0.03);
  EXPECT_EQ(found.deviation[offsetIndex(BodyCone::kThigh, 0)], 0);
}

TEST_F(SizeEstimatorTest, KnownPointsPinTheJointsDown) {
  const ContourBody body(truth);
  for (size_t i = 0; i < poses.size(); ++i) {
    instants[i].known_points = body.points(poses[i]);
    instants[i].known_points.col(3).setConstant(std::nan(""));
  }
  const ShapeEstimate found = estimate();
  const ContourBody fitted(found.shape);
  for (size_t i = 0; i < poses.size(); ++i)
    EXPECT_LT(jointDistance(body, poses[i], fitted, found.poses[i]), 0.003);
}

TEST_F(SizeEstimatorTest, IsTheSameOnAnyNumberOfThreads) {
  const auto on = [&](size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return estimate();
  };
  EXPECT_EQ(on(1).shape, on(2).shape);
}

TEST_F(SizeEstimatorTest, LeavesInstantsWithoutMasksOut) {
  instants[2].seen = ContourObserver(rig, options).observe(std::vector<cv::Mat>(rig.size()));
  EXPECT_EQ(estimate().samples_used, 5);
  for (ShapeSample& instant : instants) instant.seen = instants[2].seen;
  EXPECT_EQ(errorTextOf([&] { estimate(); }),
            "contour: no sample for the shape estimate has two usable masks");
}

TEST_F(SizeEstimatorTest, RefusesPointsThatItDoesNotKnow) {
  instants[0].known_points.resize(3, 4);
  EXPECT_THROW(estimate(), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
