#include "markerless_mocap/segmentation/body_segmenter.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "voxel_figure.h"

namespace markerless_mocap {
namespace {

constexpr double kHanging = 0.05;  // radians from the vertical: hands on the thighs
constexpr double kHalfRaised = 0.8;

BodyParts segment(const VisualHull& hull, const std::string& method = "merge_tree") {
  SegmentationOptions options;
  options.branch_method = method;
  if (method == "spline_walk") options.shrink_weight = 100.0;  // its stop at the origin needs it
  return BodySegmenter(options).segment(hull);
}

/// The label that most voxels of a true part have.
PartLabel labelOf(PartLabel part, const VoxelFigure& figure, const BodyParts& parts) {
  const std::vector<PartLabel> truth = figure.parts();
  std::array<int, kPartCount> count{};
  for (size_t v = 0; v < truth.size(); ++v) count[parts.labels[v]] += truth[v] == part;
  return PartLabel(std::max_element(count.begin(), count.end()) - count.begin());
}

double overlap(PartLabel truth_part, PartLabel label, const VoxelFigure& figure,
               const BodyParts& parts) {
  const std::vector<PartLabel> truth = figure.parts();
  double both = 0.0;
  double either = 0.0;
  for (size_t v = 0; v < truth.size(); ++v) {
    const bool in_truth = truth[v] == truth_part;
    const bool in_label = parts.labels[v] == uint8_t(label);
    both += in_truth && in_label;
    either += in_truth || in_label;
  }
  return both / either;
}

class BothMethods : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Segmenter, BothMethods, testing::Values("merge_tree", "spline_walk"));

TEST_P(BothMethods, FindTheSixPartsOfAFigure) {
  const VoxelFigure figure = standingFigure(kHalfRaised);
  const BodyParts parts = segment(figure.hull(), GetParam());
  ASSERT_EQ(parts.status, SegmentationStatus::kOk) << parts.reason;
  EXPECT_TRUE(parts.reason.empty());
  std::set<PartLabel> labels;
  for (int p = 0; p < kPartCount; ++p) {
    const PartLabel label = labelOf(PartLabel(p), figure, parts);
    labels.insert(label);
    EXPECT_GT(overlap(PartLabel(p), label, figure, parts), 0.6) << toString(PartLabel(p));
    EXPECT_TRUE(parts.parts[p].seen);
  }
  EXPECT_EQ(labels.size(), size_t(kPartCount));
  EXPECT_EQ(labelOf(PartLabel::kTorso, figure, parts), PartLabel::kTorso);
  EXPECT_EQ(labelOf(PartLabel::kHead, figure, parts), PartLabel::kHead);
}

TEST_P(BothMethods, RunLimbCurvesFromTheTorsoToTheTip) {
  const VoxelFigure figure = standingFigure(kHalfRaised);
  const BodyParts parts = segment(figure.hull(), GetParam());
  for (const PartLabel arm : {PartLabel::kArm1, PartLabel::kArm2}) {
    const PartCurve& curve = parts.part(labelOf(arm, figure, parts));
    const double side = arm == PartLabel::kArm1 ? 1.0 : -1.0;
    const Eigen::Vector3d shoulder(side * 0.21, 0, 1.38);
    const Eigen::Vector3d along(side * std::sin(kHalfRaised), 0, -std::cos(kHalfRaised));
    EXPECT_LT((curve.points.back() - shoulder - 0.70 * along).norm(), 0.08);
    EXPECT_LT((curve.points.front() - shoulder).norm(), 0.45);
    for (const Eigen::Vector3d& p : curve.points) {
      EXPECT_LT((p - shoulder).cross(along).norm(), 0.035);
    }
  }
  for (const PartLabel leg : {PartLabel::kLeg1, PartLabel::kLeg2}) {
    const PartCurve& curve = parts.part(labelOf(leg, figure, parts));
    EXPECT_LT(curve.points.back().z(), 0.12);
    EXPECT_GT(curve.points.front().z(), 0.5);
  }
  EXPECT_GT(parts.part(PartLabel::kHead).points.back().z(), 1.6);
}

TEST(BodySegmenter, RunsTheTorsoCurveFromTheLegsToTheHead) {
  for (const double angle : {kHanging, kHalfRaised, 1.57}) {
    const BodyParts parts = segment(standingFigure(angle).hull());
    const PartCurve& torso = parts.part(PartLabel::kTorso);
    ASSERT_EQ(torso.points.size(), 21u);
    EXPECT_LT(torso.points.front().z(), 1.0);
    EXPECT_GT(torso.points.back().z(), 1.25);
    for (const Eigen::Vector3d& p : torso.points) EXPECT_LT(std::abs(p.x()), 0.06);
  }
}

TEST(BodySegmenter, NamesArmsAboveTheHead) {
  const VoxelFigure figure = standingFigure(2.6);
  const BodyParts parts = segment(figure.hull());
  ASSERT_EQ(parts.status, SegmentationStatus::kOk) << parts.reason;
  EXPECT_EQ(labelOf(PartLabel::kHead, figure, parts), PartLabel::kHead);
  EXPECT_GE(labelOf(PartLabel::kLeg1, figure, parts), PartLabel::kLeg1);
}

TEST(BodySegmenter, TellsUpperArmsFromTheTrunkThatTheyLieAgainst) {
  const VoxelFigure figure =
      bentArmsFigure({0.225, 0.0, 1.08}, {0.47, 0.0, 1.05}, {0.65, 0.0, 1.05});
  const BodyParts parts = segment(figure.hull());
  ASSERT_EQ(parts.status, SegmentationStatus::kOk) << parts.reason;
  for (const PartLabel arm : {PartLabel::kArm1, PartLabel::kArm2}) {
    const PartLabel label = labelOf(arm, figure, parts);
    EXPECT_GT(overlap(arm, label, figure, parts), 0.7);
    EXPECT_GT(parts.part(label).points.front().z(), 1.2) << "its curve begins at the shoulder";
  }
}

TEST(BodySegmenter, SharesOutThighsThatTouch) {
  VoxelFigure figure = standingFigure(kHalfRaised);
  for (const int side : {1, -1})  // cloth between the thighs down to the knees
    figure.capsule({side * 0.05, 0, 0.78}, {side * 0.06, 0, 0.48}, 0.06,
                   side > 0 ? PartLabel::kLeg1 : PartLabel::kLeg2);
  const BodyParts parts = segment(figure.hull());
  ASSERT_EQ(parts.status, SegmentationStatus::kOk) << parts.reason;
  for (const PartLabel leg : {PartLabel::kLeg1, PartLabel::kLeg2})
    EXPECT_GT(overlap(leg, labelOf(leg, figure, parts), figure, parts), 0.8);
}

TEST(BodySegmenter, SaysThatAHandOnTheHipClosesALoop) {
  const VoxelFigure figure =
      bentArmsFigure({0.47, 0.0, 1.15}, {0.22, 0.0, 0.95}, {0.17, 0.0, 0.92}, false);
  const BodyParts parts = segment(figure.hull());
  ASSERT_EQ(parts.status, SegmentationStatus::kPartial) << parts.reason;
  EXPECT_NE(parts.reason.find("closes a loop: its hand touches the body"), std::string::npos)
      << parts.reason;
  const PartLabel straight = labelOf(PartLabel::kArm2, figure, parts);
  EXPECT_TRUE(parts.part(straight).whole) << parts.reason;
  EXPECT_GT(overlap(PartLabel::kArm2, straight, figure, parts), 0.6);
}

TEST(BodySegmenter, SeesNoLoopInAnArmThatIsFree) {
  for (const double gap : {0.0, 0.12}) {  // the hand on the hip, and away from it
    const BodyParts parts = segment(
        bentArmsFigure({0.47, 0.0, 1.15}, {0.22 + gap, 0.0, 0.95}, {0.17 + gap, 0.0, 0.92}).hull());
    EXPECT_EQ(parts.reason.find("loop") == std::string::npos, gap > 0.0) << parts.reason;
  }
}

TEST(BodySegmenter, DoesNotInventArmsThatTouchTheBody) {
  const BodyParts parts = segment(standingFigure(kHanging).hull());
  ASSERT_EQ(parts.status, SegmentationStatus::kPartial) << parts.reason;
  EXPECT_EQ(parts.reason.rfind("arm 1, arm 2 not seen", 0), 0u) << parts.reason;
  EXPECT_FALSE(parts.part(PartLabel::kArm1).seen);
  EXPECT_EQ(parts.part(PartLabel::kArm1).voxel_count, 0u);
  EXPECT_TRUE(parts.part(PartLabel::kLeg1).seen);
  EXPECT_TRUE(parts.part(PartLabel::kHead).seen);
}

TEST(BodySegmenter, NumbersArmsAndLegsByWhereTheyAreNotByTheirLengths) {
  for (const double side : {1.0, -1.0}) {
    VoxelFigure figure = standingFigure(kHalfRaised);  // one arm and the other leg longer
    const Eigen::Vector3d shoulder(side * 0.21, 0, 1.38);
    const Eigen::Vector3d along(side * std::sin(kHalfRaised), 0, -std::cos(kHalfRaised));
    figure.capsule(shoulder + 0.7 * along, shoulder + 0.75 * along, 0.034,
                   side > 0 ? PartLabel::kArm1 : PartLabel::kArm2);
    figure.capsule({side * -0.18, 0, 0.04}, {side * -0.18, 0.18, 0.04}, 0.04,
                   side > 0 ? PartLabel::kLeg2 : PartLabel::kLeg1);
    const BodyParts parts = segment(figure.hull());
    ASSERT_EQ(parts.status, SegmentationStatus::kOk) << parts.reason;
    for (int p = 0; p < kPartCount; ++p) {
      EXPECT_EQ(labelOf(PartLabel(p), figure, parts), PartLabel(p)) << side;
    }
  }
}

TEST(BodySegmenter, LabelsDoNotDependOnTheOrderOfVoxels) {
  VisualHull hull = standingFigure(kHalfRaised).hull();
  std::vector<uint8_t> labels = segment(hull).labels;
  std::reverse(hull.voxels.begin(), hull.voxels.end());
  std::reverse(labels.begin(), labels.end());
  EXPECT_EQ(segment(hull).labels, labels);
}

TEST(BodySegmenter, LabelsDetachedVoxelsByTheirNeighbors) {
  VoxelFigure figure = standingFigure(kHalfRaised);
  figure.capsule({0, 0, 1.85}, {0, 0, 1.86}, 0.04, PartLabel::kHead);
  const BodyParts parts = segment(figure.hull());
  EXPECT_EQ(parts.labels.back(), uint8_t(PartLabel::kHead));
}

void expectInvalid(const VisualHull& hull, const std::string& reason) {
  for (const char* method : {"merge_tree", "spline_walk"}) {
    const BodyParts parts = segment(hull, method);
    EXPECT_EQ(parts.status, SegmentationStatus::kInvalid) << method;
    EXPECT_NE(parts.reason.find(reason), std::string::npos) << parts.reason;
    EXPECT_EQ(parts.labels.size(), hull.voxels.size());
  }
}

TEST(BodySegmenter, SaysWhyAnEmptyHullIsNoPerson) {
  VisualHull hull = VoxelFigure().hull();
  expectInvalid(hull, "the hull is empty");
  hull.reason = "no camera sees anybody";
  expectInvalid(hull, "the hull is empty: no camera sees anybody");
}

TEST(BodySegmenter, SaysWhyHullsOfTheWrongSizeAreNoPerson) {
  VisualHull one = VoxelFigure().hull();
  one.voxels.resize(1);
  expectInvalid(one, "a person 15 to 200");
  expectInvalid(VoxelFigure().capsule({0, 0, 1}, {0, 0, 1.01}, 0.5).hull(), "litres");
}

TEST(BodySegmenter, RecognisesNoBodyInABallOrABlock) {
  expectInvalid(VoxelFigure().capsule({0, 0, 1}, {0, 0, 1}, 0.25).hull(), "no body is recognised");
  VoxelFigure block;
  for (double x = -0.15; x <= 0.15; x += 0.03) {
    for (double y = -0.15; y <= 0.15; y += 0.03) block.capsule({x, y, 0.1}, {x, y, 0.9}, 0.03);
  }
  expectInvalid(block.hull(), "no body is recognised");
}

TEST(BodySegmenter, RecognisesNoBodyInAChair) {
  VoxelFigure chair;
  for (const double x : {-0.2, 0.2}) {
    chair.capsule({x, -0.2, 0.03}, {x, -0.2, 0.45}, 0.04)
        .capsule({x, 0.2, 0.03}, {x, 0.2, 1.0}, 0.04);
  }
  for (double y = -0.2; y <= 0.2; y += 0.04) chair.capsule({-0.2, y, 0.45}, {0.2, y, 0.45}, 0.05);
  for (double z = 0.6; z <= 1.0; z += 0.04) chair.capsule({-0.2, 0.2, z}, {0.2, 0.2, z}, 0.04);
  expectInvalid(chair.hull(), "");
}

TEST(BodySegmenter, RefusesVoxelsOutsideTheLattice) {
  VisualHull hull = standingFigure(kHalfRaised).hull();
  hull.voxels.back().index = hull.lattice.count();
  expectInvalid(hull, "outside the hull's lattice");
}

TEST(BodySegmenter, HoldsToTheHighestCost) {
  SegmentationOptions options;
  options.max_cost = 0.1;
  const BodyParts parts = BodySegmenter(options).segment(standingFigure(kHalfRaised).hull());
  EXPECT_EQ(parts.status, SegmentationStatus::kInvalid);
  EXPECT_NE(parts.reason.find("do not fit a body"), std::string::npos) << parts.reason;
}

std::string errorTextOf(const SegmentationOptions& options) {
  try {
    BodySegmenter segmenter(options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SegmentationOptions, RefuseWhatCannotWork) {
  SegmentationOptions options;
  EXPECT_EQ(errorTextOf(options), "");
  options.branch_method = "guess";
  EXPECT_NE(errorTextOf(options).find("branch_method"), std::string::npos);
  options = {};
  options.shrink_weight = -1.0;
  EXPECT_NE(errorTextOf(options).find("shrink_weight"), std::string::npos);
  options = {};
  options.min_litres = 200.0;
  EXPECT_EQ(errorTextOf(options),
            "body_segmentation/min_litres is 200.000000, allowed is less than max_litres, which is "
            "200.000000");
}

TEST(PartLabel, HasNames) {
  EXPECT_STREQ(toString(PartLabel::kTorso), "torso");
  EXPECT_STREQ(toString(PartLabel::kLeg2), "leg 2");
  EXPECT_STREQ(toString(SegmentationStatus::kPartial), "partial");
}

}  // namespace
}  // namespace markerless_mocap
