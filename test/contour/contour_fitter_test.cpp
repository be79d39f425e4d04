#include "contour/fit/contour_fitter.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Cholesky>
#include <limits>
#include <stdexcept>

#include "contour/drawn_body.h"
#include "contour/fit/pose_priors.h"
#include "contour/fit/pose_problem.h"
#include "contour/measure/shape_equations.h"

namespace markerless_mocap {
namespace {

class ContourFitterTest : public ::testing::Test {
 protected:
  ContourFitterTest()
      : rig(drawnRig(6)), body(ShapeStatistics::handMade().meanShape(1.75)), fitter(rig, options) {
    seen = ContourObserver(rig, options).observe(drawnMasks(rig, body, stride()));
  }
  double error(const ContourPose& pose) const { return jointDistance(body, pose, body, stride()); }
  /// Half the robust error of rays and containment.
  double energy(const ContourBody& of, const ContourPose& pose, double outlier) const {
    PoseProblem problem(seen, rig, options);
    problem.evaluate(of, pose, outlier);
    double sum = 0;
    for (const RayMatch& match : problem.matches()) {
      const double r2 = double(match.residual) * match.residual;
      sum += options.effective_rays / double(seen.rays.size()) * r2 / (1 + r2 / outlier / outlier);
    }
    return 0.5 * sum / (options.ray_sigma * options.ray_sigma);
  }

  ContourOptions options;
  CameraRig rig;
  ContourBody body;
  ContourFitter fitter;
  ContourObservation seen;
};

/// Poses and sizes half a millimetre or milliradian to both sides of given ones, by unknown.
struct Neighbour {
  ContourBody body;
  ContourPose pose;
};
std::vector<Neighbour> neighbours(const ContourBody& body, const ContourPose& pose, double by) {
  std::vector<Neighbour> out;
  for (int i = 0; i < kContourDof; ++i)
    for (const double step : {by, -by})
      out.push_back({body, boxPlus(pose, step * PoseIncrement::Unit(i))});
  for (int i = 0; i < kShapeParameterCount; ++i)
    for (const double step : {by, -by})
      out.push_back({ContourBody(body.shape() + step * ShapeParameters::Unit(i)), pose});
  return out;
}

TEST_F(ContourFitterTest, RayDerivativesAreThoseOfDifferences) {
  options.containment_weight = 0;
  constexpr double kOutlier = 0.1, kStep = 2e-4;
  const ContourPose pose = disturbed(stride(), 0.05, 0.01, 1);
  const std::vector<Neighbour> around = neighbours(body, pose, kStep);
  // Only rays that stay with their cone have a derivative there; that of a ray on the wrong side
  // leaves out that its place on the axis moves.
  const auto match = [&](const Neighbour& at) {
    PoseProblem problem(seen, rig, options);
    problem.evaluate(at.body, at.pose, kOutlier);
    return problem.matches();
  };
  const std::vector<RayMatch> here = match({body, pose});
  std::vector<bool> stays(here.size());
  for (size_t i = 0; i < here.size(); ++i) stays[i] = here[i].along_side != 0;
  for (const Neighbour& at : around) {
    const std::vector<RayMatch> there = match(at);
    for (size_t i = 0; i < here.size(); ++i)
      if (there[i].cone != here[i].cone || there[i].along_side == 0) stays[i] = false;
  }
  ContourObservation steady = seen;
  steady.rays.clear();
  for (size_t i = 0; i < here.size(); ++i)
    if (stays[i]) steady.rays.push_back(seen.rays[i]);
  seen = steady;
  ASSERT_GT(seen.rays.size(), here.size() * 7 / 10);

  const ShapeNormalEquations equations =
      shapeNormalEquations(rig, options, body, {seen, pose, {}}, pose, kOutlier, 1.0);
  PoseNormalEquations posture;
  posture.clear();
  addPosturePriors(pose, posture);
  Eigen::VectorXd slope = equations.g;
  slope.head<kContourDof>() -= posture.g;
  for (Eigen::Index i = 0; i < slope.size(); ++i) {
    const Neighbour &more = around[size_t(2 * i)], &less = around[size_t(2 * i + 1)];
    const double difference =
        (energy(more.body, more.pose, kOutlier) - energy(less.body, less.pose, kOutlier)) /
        (2 * kStep);
    EXPECT_NEAR(slope[i], difference, 2e-3 * slope.norm()) << i;
  }
}

TEST_F(ContourFitterTest, RaysMeetACappedConeWhereItIsNearest) {
  // One cone from the origin up, 0.1 m thick at its lower end and 0.3 m at its upper one; all
  // others are far away. Rays run along x, and their contours look to the left.
  ContourWorldCones cones;
  for (ContourWorldCone& cone : cones) cone = {{0, -1e3, 0}, {0, -1e3, 0}, 0.1, 0.1};
  cones[7] = {{0, 0, 0}, {0, 0, 1}, 0.1, 0.3};
  const auto matchAt = [&](double y, double z) {
    seen.rays = {{{0, 1, 0}, {0, 0, 1}, float(y), float(z), 0, {0, 0}}};
    std::vector<RayMatch> matches;
    matchRays(ConesInViews(seen, cones), seen.rays, matches);
    return matches.front();
  };
  // The outline leans outward by asin(0.2).
  const double cosine = std::sqrt(1 - 0.2 * 0.2);
  const RayMatch beside = matchAt(0.5, 0.4);
  EXPECT_EQ(beside.cone, 7);
  EXPECT_NEAR(beside.residual, 0.5 * cosine - 0.4 * 0.2 - 0.1, 1e-5);
  EXPECT_NEAR(beside.s, 0.4 + 0.5 * 0.2 / cosine, 1e-5);
  const RayMatch below = matchAt(0.3, -0.4);
  EXPECT_EQ(below.s, 0);
  EXPECT_NEAR(below.residual, 0.5 - 0.1, 1e-5);
  EXPECT_NEAR(below.along_normal, -0.6, 1e-5);
  EXPECT_NEAR(below.along_side, 0.8, 1e-5);
}

// A fit that diverges places it there.
TEST_F(ContourFitterTest, RaysAreMatchedToBodiesOutOfAllRange) {
  for (const double place : {1e3, 1e15, 1e25, 1e300}) {
    ContourPose pose = stride();
    pose.position.setConstant(place);
    PoseProblem problem(seen, rig, options);
    problem.evaluate(body, pose, 0.1);
    for (const RayMatch& match : problem.matches()) {
      ASSERT_GE(match.cone, 0) << place;
      ASSERT_LT(match.cone, kContourCones) << place;
    }
  }
}

TEST_F(ContourFitterTest, PriorDerivativesAreThoseOfDifferences) {
  ContourPose pose = disturbed(stride(), 0.3, 0.1, 5);
  pose.angles[RevoluteJoint::kLeftKnee] = 0.4;                          // beyond its limit
  pose.rotations[SphericalJoint::kRightHip] = expSO3({0.8, 0.9, 1.3});  // beyond three
  const ContourPose expected = disturbed(pose, 0.4, 0.1, 6);
  PoseNormalEquations equations;
  equations.clear();
  addPosturePriors(pose, equations);
  addArmRestPrior(pose, equations);
  addMotionPrior(pose, expected, 0.2, 0.05, equations);
  const auto energyAt = [&](const ContourPose& at) {
    const PoseIncrement away = boxMinus(at, expected);
    return postureEnergy(at) + armRestEnergy(at) +
           0.5 * away.head<3>().squaredNorm() / (0.05 * 0.05) +
           0.5 * away.tail<kContourDof - 3>().squaredNorm() / (0.2 * 0.2);
  };
  for (int dof = 0; dof < kContourDof; ++dof) {
    const PoseIncrement step = 1e-5 * PoseIncrement::Unit(dof);
    const double difference =
        (energyAt(boxPlus(pose, step)) - energyAt(boxPlus(pose, -step))) / 2e-5;
    EXPECT_NEAR(equations.g[dof], difference, 1e-3 * (1 + std::abs(difference))) << dof;
  }
}

TEST_F(ContourFitterTest, AnArmThatNothingHoldsComesToHang) {
  ContourPose pose;  // arms to the sides, elbows bent
  pose.rotations[SphericalJoint::kLeftShoulder] = expSO3({1.5, 0, 0});
  pose.rotations[SphericalJoint::kRightShoulder] = expSO3({-1.5, 0, 0});
  pose.angles[RevoluteJoint::kLeftElbow] = pose.angles[RevoluteJoint::kRightElbow] = 1.5;
  const auto heightOf = [&](Eigen::Index wrist) { return body.points(pose)(2, wrist); };
  for (int i = 0; i < 30; ++i) {
    PoseNormalEquations posture;
    posture.clear();
    addPosturePriors(pose, posture);
    addArmRestPrior(pose, posture);
    posture.H.diagonal().array() += 1.0;
    pose = boxPlus(pose, -posture.H.ldlt().solve(posture.g).cwiseMax(-0.2).cwiseMin(0.2));
  }
  const double hanging = body.points(ContourPose())(2, 5);
  EXPECT_NEAR(heightOf(5), hanging, 0.03);
  EXPECT_NEAR(heightOf(8), hanging, 0.03);
}

TEST_F(ContourFitterTest, ARaisedArmIsPulledNoMoreThanOneThatHangsNearly) {
  const auto pullAt = [&](double raised) {
    ContourPose pose;
    pose.rotations[SphericalJoint::kLeftShoulder] = expSO3({raised, 0, 0});
    PoseNormalEquations posture;
    posture.clear();
    addArmRestPrior(pose, posture);
    return posture.g[sphericalDof(SphericalJoint::kLeftShoulder)];
  };
  EXPECT_GT(pullAt(0.6), 5.0);
  EXPECT_LT(pullAt(1.5), 1.2 * pullAt(0.6));
  EXPECT_LT(pullAt(2.2), 1.2 * pullAt(0.6));
}

TEST_F(ContourFitterTest, ContainmentPullsABodyBackInside) {
  ContourPose outside = stride();
  outside.position.x() += 0.3;
  ContourWorldCones cones;
  ContourFrames frames;
  body.place(outside, frames);
  body.place(frames, cones);
  AllConeNormalEquations sums;
  addContainment(seen, rig, cones, 1.0, 0, rig.size(), sums);
  PoseNormalEquations equations;
  equations.clear();
  accumulatePoseEquations(sums, frames, cones, equations);
  EXPECT_GT(equations.g[0], 0);  // less x is better
  EXPECT_GT(equations.g[0], 3 * std::abs(equations.g[1]));
}

TEST_F(ContourFitterTest, FindsTheDrawnPose) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const ContourPose start = disturbed(stride(), 0.1, 0.03, seed);
    EXPECT_GT(error(start), 0.03);
    const ContourFit fit = fitter.fit(seen, body, start, std::nullopt, RobustSchedule::wide());
    ASSERT_EQ(fit.status, ContourFitStatus::kFitted);
    EXPECT_LT(error(fit.pose), 0.008) << seed;
    EXPECT_GT(fit.overlap, 0.95);
    EXPECT_GT(fit.rays_explained, 0.99);
    for (const LimbEvidence& limb : fit.limbs) {
      EXPECT_GT(limb.rays, 10);
      EXPECT_LT(limb.outside, 0.012);
      EXPECT_LT(limb.deviation, 0.02);
    }
  }
}

TEST_F(ContourFitterTest, FollowsFromThePredictedPose) {
  const ContourPose start = disturbed(stride(), 0.04, 0.01, 2);
  const ContourFit fit =
      fitter.fit(seen, body, start, ContourPrediction{start, 1.0 / 30}, fitter.schedule(1.0 / 30));
  EXPECT_LT(error(fit.pose), 0.008);
}

TEST_F(ContourFitterTest, TakesFewerStepsFromARecentPose) {
  ASSERT_EQ(options.iterations, 8);
  EXPECT_EQ(fitter.schedule(1.0 / 10).iterations, 8);
  EXPECT_EQ(fitter.schedule(1.0 / 20).iterations, 6);
  EXPECT_EQ(fitter.schedule(1.0 / 30).iterations, 4);
  EXPECT_EQ(fitter.schedule(1.0 / 100).iterations, 4);
}

TEST_F(ContourFitterTest, TellsOfALimbThatTheMasksDoNotShow) {
  ShapeParameters stump =
      body.shape();  // forearms and hands so short that nothing is drawn of them
  stump[BodyLength::kForearm] = stump[BodyLength::kHand] = 0.01;
  const ContourObservation cut =
      ContourObserver(rig, options).observe(drawnMasks(rig, ContourBody(stump), stride()));
  const ContourFit whole =
      fitter.fit(seen, body, stride(), std::nullopt, fitter.schedule(1.0 / 15));
  const ContourFit lacking =
      fitter.fit(cut, body, stride(), std::nullopt, fitter.schedule(1.0 / 15));
  for (const int arm : {ContourLimb::kLeftArm, ContourLimb::kRightArm})
    EXPECT_LT(lacking.limbs[size_t(arm)].rays, 0.75 * whole.limbs[size_t(arm)].rays);
  EXPECT_LT(lacking.overlap, whole.overlap - 0.01);
}

TEST_F(ContourFitterTest, KeepsJointLimits) {
  ContourPose broken = stride();
  broken.angles[RevoluteJoint::kLeftKnee] = 0.6;
  broken.angles[RevoluteJoint::kRightElbow] = -0.5;
  broken.rotations[SphericalJoint::kLeftHip] =
      expSO3({0, 0, 1.3}) * broken.rotations[SphericalJoint::kLeftHip];
  EXPECT_GT(maxLimitViolation(broken), 0.4);
  const ContourFit fit = fitter.fit(seen, body, broken, std::nullopt, RobustSchedule::wide());
  EXPECT_LT(maxLimitViolation(fit.pose), 0.05);
}

TEST_F(ContourFitterTest, NeedsTwoUsableViews) {
  std::vector<cv::Mat> masks(rig.size());
  const cv::Mat empty = cv::Mat::zeros(240, 320, CV_8UC1), full = empty + 255;
  masks[0] = empty;
  masks[1] = full;
  const auto drawn = drawnMasks(rig, body, stride());
  masks[2] = drawn[2];
  const ContourObserver observer(rig, options);
  const auto statusOf = [&] {
    return fitter
        .fit(observer.observe(masks), body, stride(), std::nullopt, fitter.schedule(1.0 / 15))
        .status;
  };
  EXPECT_EQ(statusOf(), ContourFitStatus::kTooFewViews);
  masks[3] = drawn[3];
  EXPECT_EQ(statusOf(), ContourFitStatus::kFitted);
}

TEST_F(ContourFitterTest, RefusesWhatIsNotFiniteOrOfAnotherRig) {
  ContourPose bad = stride();
  bad.position.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fitter.fit(seen, body, bad, std::nullopt, fitter.schedule(1.0 / 15)),
               std::invalid_argument);
  EXPECT_THROW(
      fitter.fit(seen, body, stride(), ContourPrediction{bad, 0.1}, fitter.schedule(1.0 / 15)),
      std::invalid_argument);
  EXPECT_THROW(
      fitter.fit(seen, body, stride(), ContourPrediction{stride(), 0}, fitter.schedule(1.0 / 15)),
      std::invalid_argument);
  EXPECT_THROW(ContourFitter(drawnRig(3), options)
                   .fit(seen, body, stride(), std::nullopt, fitter.schedule(1.0 / 15)),
               std::invalid_argument);
}

TEST_F(ContourFitterTest, GoesOnAsFastAsBefore) {
  ContourPose before, last;
  last.position.x() = 0.1;
  last.angles[RevoluteJoint::kLeftElbow] = 0.2;
  last.rotations[SphericalJoint::kNeck] = expSO3({0, 0, 0.4});
  const ContourPose next = predictConstantVelocity(before, last, 0.5);
  EXPECT_NEAR(next.position.x(), 0.15, 1e-12);
  EXPECT_NEAR(next.angles[RevoluteJoint::kLeftElbow], 0.3, 1e-12);
  EXPECT_NEAR(logSO3(next.rotations[SphericalJoint::kNeck]).z(), 0.6, 1e-9);
}

}  // namespace
}  // namespace markerless_mocap
