#include "contour/measure/online_shape_estimator.h"

#include <gtest/gtest.h>

#include <thread>

#include "contour/drawn_body.h"

namespace markerless_mocap {
namespace {

constexpr int kPoses = 6;
constexpr int64_t kMillisecond_ns = 1000000;

ContourOptions fewRays() {
  ContourOptions options;
  options.rays = 400;
  return options;
}

/// A person smaller than believed, with long thighs.
ShapeParameters truth() {
  ShapeParameters shape = ShapeStatistics::handMade().meanShape(1.65);
  shape[BodyLength::kThigh] *= 1.05;
  shape[radiusIndex(BodyCone::kThigh, 0)] *= 1.1;
  return shape;
}

ShapePrior believed() {
  ShapePrior prior;
  prior.shape_statistics = ShapeStatistics::handMade();
  prior.stature = 1.8;
  return prior;
}

/// The i-th pose of one who moves about.
ContourPose poseOf(unsigned i) {
  return disturbed(stride(), 0.25, 0.1, 10 + i);
}

class BodyMeasurerTest : public ::testing::Test {
 protected:
  static OnlineShapeEstimator measurer(bool in_background, int poses = kPoses) {
    return {drawnRig(5), fewRays(), believed(), poses, in_background};
  }
  ContourObservation see(const ContourPose& pose) const {
    return observer.observe(drawnMasks(rig, ContourBody(truth()), pose));
  }
  static ContourFit fitAt(const ContourPose& pose) {
    ContourFit fit;
    fit.status = ContourFitStatus::kFitted;
    fit.pose = pose;
    fit.overlap = 0.9;
    return fit;
  }
  /// Shows a pose as a tracker with the believed sizes has fitted it.
  void show(unsigned i, OnlineShapeEstimator& to) const {
    to.add(i * 100 * kMillisecond_ns, see(poseOf(i)), body,
           fitAt(disturbed(poseOf(i), 0.04, 0.02, 50 + i)));
  }
  /// Shows a pose without masks, which need not be seen to be counted.
  void count(int64_t milliseconds, const ContourFit& fit, OnlineShapeEstimator& by) const {
    by.add(milliseconds * kMillisecond_ns, {}, body, fit);
  }
  static double offBy(const ShapeParameters& shape) {
    return (shape - truth()).head<BodyLength::kCount>().norm();
  }

  CameraRig rig = drawnRig(5);
  ContourBody body{believed().shape_statistics.meanShape(1.8)};
  ContourObserver observer{rig, fewRays()};
};

TEST_F(BodyMeasurerTest, TakesADifferentPoseSoonAndTheSameOneOnlyAfterTime) {
  OnlineShapeEstimator measurer = this->measurer(false, 30);
  ContourFit fit = fitAt(stride());
  count(0, fit, measurer);
  EXPECT_EQ(measurer.poses(), 1);
  count(100, fit, measurer);
  count(290, fit, measurer);
  EXPECT_EQ(measurer.poses(), 1) << "the same pose";
  count(310, fit, measurer);
  EXPECT_EQ(measurer.poses(), 2) << "the same pose after time";
  fit.pose.position.x() += 0.06;
  count(360, fit, measurer);
  EXPECT_EQ(measurer.poses(), 2) << "another pose, but in the next instant";
  count(380, fit, measurer);
  EXPECT_EQ(measurer.poses(), 3) << "another pose";
  fit.pose.position.x() += 0.03;
  count(480, fit, measurer);
  EXPECT_EQ(measurer.poses(), 3) << "nearly the same pose";
}

TEST_F(BodyMeasurerTest, GoesOnWhenStampsGoBack) {
  OnlineShapeEstimator measurer = this->measurer(false, 30);
  ContourFit fit = fitAt(stride());
  count(100000, fit, measurer);
  fit.pose.position.x() += 0.06;
  count(10, fit, measurer);
  count(80, fit, measurer);
  EXPECT_EQ(measurer.poses(), 2);
  count(310 + 80, fit, measurer);
  EXPECT_EQ(measurer.poses(), 3);
}

TEST_F(BodyMeasurerTest, LeavesFitsThatCoverTheMasksBadlyOut) {
  OnlineShapeEstimator measurer = this->measurer(false);
  ContourFit fit = fitAt(stride());
  fit.overlap = 0.6;
  count(0, fit, measurer);
  EXPECT_EQ(measurer.poses(), 0);
}

TEST_F(BodyMeasurerTest, SizesComeNearerToThePersonsOnceThereAreEnoughPoses) {
  OnlineShapeEstimator measurer = this->measurer(false);
  for (unsigned i = 0; i < kPoses; ++i) {
    EXPECT_FALSE(measurer.isEstimating()) << i;
    EXPECT_FALSE(measurer.shape()) << i;
    show(i, measurer);
  }
  EXPECT_TRUE(measurer.isEstimating());
  show(kPoses, measurer);
  EXPECT_EQ(measurer.poses(), kPoses) << "no more are taken in";
  const std::optional<ShapeParameters> shape = measurer.shape();
  ASSERT_TRUE(shape);
  EXPECT_LT(offBy(*shape), 0.4 * offBy(body.shape()));
  EXPECT_NEAR((*shape)[BodyLength::kThigh], truth()[BodyLength::kThigh], 0.015);
  const int thigh = radiusIndex(BodyCone::kThigh, 0);
  EXPECT_NEAR((*shape)[thigh], truth()[thigh], 0.006);
}

TEST_F(BodyMeasurerTest, InBackgroundTheResultIsTheSame) {
  OnlineShapeEstimator waiting = measurer(false), background = measurer(true);
  for (unsigned i = 0; i < kPoses; ++i) {
    show(i, waiting);
    show(i, background);
  }
  std::optional<ShapeParameters> shape;
  while (!(shape = background.shape())) std::this_thread::yield();
  EXPECT_EQ(*shape, *waiting.shape());
}

TEST_F(BodyMeasurerTest, EstimatesFromTheFewItHasWhenAskedTo) {
  OnlineShapeEstimator measurer = this->measurer(false);
  measurer.estimateNow();
  EXPECT_FALSE(measurer.isEstimating()) << "from nothing";
  for (unsigned i = 0; i < 2; ++i) show(i, measurer);
  measurer.estimateNow();
  EXPECT_TRUE(measurer.isEstimating());
  const std::optional<ShapeParameters> shape = measurer.shape();
  ASSERT_TRUE(shape);
  EXPECT_LT(offBy(*shape), offBy(body.shape()));
}

TEST_F(BodyMeasurerTest, OneWhoHardlyMovesIsMeasuredFromFewerPosesAfterAWhile) {
  OnlineShapeEstimator measurer = this->measurer(false, 30);
  const ContourFit fit = fitAt(stride());
  for (int i = 0; i < 8; ++i) count(600 * i, fit, measurer);
  EXPECT_EQ(measurer.poses(), 8);
  EXPECT_FALSE(measurer.isEstimating()) << "4.2 s";
  count(4990, fit, measurer);
  EXPECT_FALSE(measurer.isEstimating());
  count(5300, fit, measurer);
  EXPECT_TRUE(measurer.isEstimating());
  EXPECT_EQ(measurer.poses(), 10);

  OnlineShapeEstimator doubted = this->measurer(false, 30);
  for (int i = 0; i < 8; ++i) count(310 * i, fit, doubted);
  doubted.skip(4'990'000'000);
  EXPECT_FALSE(doubted.isEstimating());
  doubted.skip(5'010'000'000);
  EXPECT_TRUE(doubted.isEstimating()) << "no pose has been believed for some time";

  OnlineShapeEstimator rare = this->measurer(false, 30);
  for (int i = 0; i < 7; ++i) count(1000 * i, fit, rare);
  EXPECT_FALSE(rare.isEstimating()) << "seven are too few even after 6 s";
  count(7000, fit, rare);
  EXPECT_TRUE(rare.isEstimating());
}

}  // namespace
}  // namespace markerless_mocap
