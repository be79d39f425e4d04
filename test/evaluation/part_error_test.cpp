#include "evaluation/part_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

constexpr double kPitch = 0.03;

/// By partTruthNames(): arms out to the sides, or hanging `arm_gap` metres beside the hips.
Eigen::Matrix3Xd standing(bool arms_out, double arm_gap = 0.3) {
  Eigen::Matrix3Xd points(3, 20);
  points.col(0) << 0, 0, 0.95;
  points.col(1) << 0, 0, 1.45;
  points.col(2) << 0, 0, 1.6;
  points.col(3) << 0, 0, 1.75;
  for (const int side : {0, 1}) {
    const int p = 4 + 8 * side;
    const double y = side ? -1.0 : 1.0;
    points.col(p) << 0, y * 0.2, 1.4;
    for (int i = 1; i <= 3; ++i) {
      const double way = i == 3 ? 0.72 : 0.27 * i;
      points.col(p + i) = arms_out
                              ? Eigen::Vector3d(0, y * (0.2 + way), 1.4)
                              : Eigen::Vector3d(0, y * (0.2 + arm_gap * way / 0.72), 1.4 - way);
    }
    points.col(p + 4) << 0, y * 0.12, 0.93;
    points.col(p + 5) << 0, y * 0.14, 0.5;
    points.col(p + 6) << 0, y * 0.16, 0.08;
    points.col(p + 7) << 0.2, y * 0.16, 0.03;
  }
  return points;
}

/// All voxels within 6 cm of a line between points that follow each other in the body, labelled by
/// the truth.
SegmentedHull perfectHull(const Eigen::Matrix3Xd& points) {
  const std::pair<int, int> lines[] = {{0, 1},   {1, 3},   {4, 5},   {5, 6},   {6, 7},   {8, 9},
                                       {9, 10},  {10, 11}, {12, 13}, {13, 14}, {14, 15}, {16, 17},
                                       {17, 18}, {18, 19}, {4, 12},  {8, 16},  {4, 8},   {12, 16}};
  const PartTruth truth(points);
  SegmentedHull hull;
  hull.pitch = kPitch;
  hull.valid = true;
  std::vector<Eigen::Vector3d> voxels;
  for (int x = -3; x <= 9; ++x)
    for (int y = -34; y <= 34; ++y)
      for (int z = 0; z <= 60; ++z) {
        const Eigen::Vector3d at = kPitch * Eigen::Vector3d(x, y, z);
        for (const auto& [i, j] : lines) {
          const Eigen::Vector3d a = points.col(i), along = points.col(j) - a;
          const double share = std::clamp((at - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
          if ((at - a - share * along).norm() > 0.06) continue;
          voxels.push_back(at);
          break;
        }
      }
  hull.voxels.resize(3, Eigen::Index(voxels.size()));
  for (size_t v = 0; v < voxels.size(); ++v) {
    hull.voxels.col(Eigen::Index(v)) = voxels[v];
    hull.labels.push_back(truth.partAt(voxels[v]));
  }
  return hull;
}

void rename(SegmentedHull& hull, uint8_t a, uint8_t b) {
  for (uint8_t& label : hull.labels) label = label == a ? b : label == b ? a : label;
}

TEST(PartTruth, putsPointsToTheNearestBonesFlesh) {
  const PartTruth truth(standing(true));
  const auto part = [&](double x, double y, double z) { return truth.partAt({x, y, z}); };
  EXPECT_EQ(part(0.1, 0.05, 1.2), TruePart::kTorso);
  EXPECT_EQ(part(0.05, 0.0, 1.65), TruePart::kHead);
  EXPECT_EQ(part(0.0, 0.5, 1.42), TruePart::kLeftArm);
  EXPECT_EQ(part(0.0, -0.5, 1.42), TruePart::kRightArm);
  EXPECT_EQ(part(0.15, 0.16, 0.05), TruePart::kLeftLeg);
  EXPECT_EQ(part(0.0, -0.13, 0.7), TruePart::kRightLeg);
  EXPECT_TRUE(truth.isDistal({0.0, 0.6, 1.4}));
  EXPECT_FALSE(truth.isDistal({0.0, 0.3, 1.4})) << "an upper arm";
  EXPECT_FALSE(truth.isDistal({0.0, 0.0, 1.2}));
}

TEST(PartTruth, measuresFromThePartsAxis) {
  const PartTruth truth(standing(true));
  EXPECT_NEAR(truth.toAxis({0.03, 0.4, 1.4}, 2), 0.03, 1e-12);
  EXPECT_NEAR(truth.toAxis({0.0, 1.02, 1.4}, 2), 0.1, 1e-12) << "the hand ends at 0.92";
  EXPECT_NEAR(truth.toAxis({0.04, 0.03, 1.2}, 0), 0.05, 1e-12);
}

TEST(PartTruth, needsAllPoints) {
  Eigen::Matrix3Xd points = standing(true);
  points(1, 7) = NAN;
  EXPECT_THROW(PartTruth{points}, std::invalid_argument);
  EXPECT_THROW(PartTruth{Eigen::Matrix3Xd::Zero(3, 4)}, std::invalid_argument);
}

TEST(PartError, findsNothingWrongWithTheTruth) {
  const Eigen::Matrix3Xd points = standing(true);
  const PartEvaluation verdict = evaluateParts(points, perfectHull(points));
  EXPECT_TRUE(verdict.evaluated && verdict.free && verdict.all_six_correct && verdict.valid);
  EXPECT_EQ(verdict.fraction_correct, 1.0);
  EXPECT_EQ(verdict.fraction_correct_inside, 1.0);
  for (const double overlap : verdict.overlap) EXPECT_EQ(overlap, 1.0);
}

TEST(PartError, leavesSidesOpenButNotKinds) {
  const Eigen::Matrix3Xd points = standing(true);
  SegmentedHull hull = perfectHull(points);
  rename(hull, 2, 3);
  EXPECT_EQ(evaluateParts(points, hull).fraction_correct, 1.0);
  rename(hull, 3, 4);
  const PartEvaluation exchanged = evaluateParts(points, hull);
  EXPECT_LT(exchanged.fraction_correct, 0.75) << "an arm for a leg";
  EXPECT_FALSE(exchanged.all_six_correct);
}

TEST(PartError, tellsMistakesAtBordersFromOthers) {
  const Eigen::Matrix3Xd points = standing(true);
  SegmentedHull hull = perfectHull(points);
  size_t wrong = 0, left_arm = 0;
  for (size_t v = 0; v < hull.labels.size(); ++v) {
    left_arm += hull.labels[v] == 2;
    // The voxels of the left arm next to its border are given to the torso.
    if (hull.labels[v] != 2 || hull.voxels(1, Eigen::Index(v)) > 0.29) continue;
    hull.labels[v] = 0;
    ++wrong;
  }
  ASSERT_GT(wrong, 0u);
  const PartEvaluation verdict = evaluateParts(points, hull);
  EXPECT_NEAR(verdict.fraction_correct, 1.0 - double(wrong) / double(hull.labels.size()), 1e-12);
  EXPECT_GT(verdict.fraction_correct_inside, verdict.fraction_correct);
  EXPECT_NEAR(verdict.overlap[2], double(left_arm - wrong) / double(left_arm), 1e-12);
}

TEST(PartError, callsAFrameFreeWhileNoForearmTouches) {
  const auto isFree = [](double gap) {
    const Eigen::Matrix3Xd points = standing(false, gap);
    return evaluateParts(points, perfectHull(points)).free;
  };
  EXPECT_TRUE(isFree(0.4));
  EXPECT_FALSE(isFree(0.0)) << "the hands lie at the thighs";
}

TEST(PartError, measuresCurvesFromTheBones) {
  const Eigen::Matrix3Xd points = standing(true);
  SegmentedHull hull = perfectHull(points);
  hull.curves[3].resize(3, 2);  // the other name of the left arm
  hull.curves[3] << 0.02, 0.0, 0.3, 0.6, 1.4, 1.44;
  rename(hull, 2, 3);
  JointTrack truth;
  truth.names = partTruthNames();
  truth.add(0, points);
  truth.add(1, Eigen::Matrix3Xd::Constant(3, 20, NAN));
  const PartErrors errors = partErrors(truth, {hull, hull});
  EXPECT_NEAR(errors.verdicts[0].curve_mm[2], 30.0, 1e-9);
  EXPECT_TRUE(std::isnan(errors.verdicts[0].curve_mm[3]));
  EXPECT_NEAR(errors.arms_mm.mean, 30.0, 1e-9);
  EXPECT_FALSE(errors.verdicts[1].evaluated) << "there is no truth";
  EXPECT_EQ(errors.all.frames, 1u);
  EXPECT_EQ(errors.fraction_valid, 1.0);
  EXPECT_EQ(errors.touching.frames, 0u);
  EXPECT_TRUE(std::isnan(errors.touching.fraction_correct));
}

TEST(PartError, refusesLabelsThatAreNone) {
  JointTrack truth;
  truth.names = partTruthNames();
  truth.add(0, standing(true));
  SegmentedHull hull = perfectHull(standing(true));
  EXPECT_THROW(partErrors(truth, {}), std::invalid_argument);
  hull.labels[0] = 6;
  EXPECT_EQ(errorTextOf([&] { partErrors(truth, {hull}); }),
            "a segmented hull needs one label below 6 for each voxel");
}

}  // namespace
}  // namespace markerless_mocap
