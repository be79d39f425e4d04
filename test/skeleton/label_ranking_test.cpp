#include "skeleton/labelling/label_ranking.h"

#include <gtest/gtest.h>

#include "skeleton/labelling/label_proportions.h"
#include "skeleton/tree_figure.h"

namespace markerless_mocap {
namespace {

using namespace label_ratio;

std::array<ExtremityPathLengths, kUnsidedExtremityCount> idealPathLengths(double longest) {
  const ExtremityPathLengths neck{kNeck * longest, kNeck * longest},
      arm{kArm * longest, kArm * longest};
  const ExtremityPathLengths leg{(kLeg + kTorso) * longest, kLeg * longest};
  return {neck, arm, arm, leg, leg};
}

/// The ideal tree drawn with arms out, `longest` metres from hand to foot.
CurveSkeleton idealSkeleton(double longest, double pitch) {
  TreeFigure figure(pitch);
  const Eigen::Vector3d crotch(0, 0, 0.1 + kLeg * longest);
  const Eigen::Vector3d origin = crotch + Eigen::Vector3d(0, 0, kTorso * longest);
  figure.line(crotch, origin).line(origin, origin + Eigen::Vector3d(0, 0, kNeck * longest));
  for (const int side : {1, -1}) {
    figure.line(origin, origin + Eigen::Vector3d(0, side * kArm * longest, 0));
    figure.line(crotch, crotch + longest * kLeg * Eigen::Vector3d(0, side * 0.28, -0.96));
  }
  return figure.skeleton();
}

PoseTreeOptions pruned(double prune_ratio) {
  PoseTreeOptions options;
  options.prune_ratio = prune_ratio;
  return options;
}

double rankOf(const std::array<ExtremityPathLengths, kUnsidedExtremityCount>& path_lengths,
              int degree = 4, const PoseTreeOptions& options = {}) {
  return originRank(path_lengths, degree, 2.0, options);
}

/// Path lengths of the ideal tree if the origin is moved from where arms, neck and torso meet, up
/// into the neck or down into the torso.
std::array<ExtremityPathLengths, kUnsidedExtremityCount> withOriginMoved(double up) {
  auto path_lengths = idealPathLengths(2.0);
  for (size_t i = 1; i <= 2; ++i) path_lengths[i].to_origin += std::abs(up);
  for (size_t i = 3; i <= 4; ++i) path_lengths[i].to_origin += up;
  path_lengths[0].to_origin -= up;
  return path_lengths;
}

TEST(LabelRanking, RatiosOfTheLongestPathSumToOne) {
  EXPECT_NEAR(kArm + kTorso + kLeg, 1.0, 0.002);
}

TEST(LabelRanking, IdealTreeHasTheRankOfItsLegs) {
  const double leg = kLeg / (kLeg + kTorso);  // Eq. 2 compares I_leg with all of the way
  EXPECT_NEAR(rankOf(idealPathLengths(2.0)), leg * leg, 1e-9);
  EXPECT_NEAR(originRank(idealPathLengths(1.5), 4, 1.5, {}), leg * leg, 1e-9);
}

TEST(LabelRanking, EachFactorIsAsPublished) {
  const double ideal = rankOf(idealPathLengths(2.0));
  auto path_lengths = idealPathLengths(2.0);
  EXPECT_NEAR(rankOf(path_lengths, 3), ideal * std::exp(-1.0 / 3.0), 1e-9);
  path_lengths[size_t(UnsidedExtremity::kHead)] = {0.5 * kNeck * 2.0, 0.5 * kNeck * 2.0};
  EXPECT_NEAR(rankOf(path_lengths), 0.5 * ideal, 1e-9);
  path_lengths = idealPathLengths(2.0);
  path_lengths[size_t(UnsidedExtremity::kFoot1)] = {kLeg * 2.0, (kLeg - 0.5 * kTorso) * 2.0};
  EXPECT_NEAR(rankOf(path_lengths), 0.5 * ideal * (kLeg + kTorso) / kLeg, 1e-9);
  path_lengths = idealPathLengths(2.0);
  path_lengths[size_t(UnsidedExtremity::kHand2)].to_branching -= 2.0 / 128.0;
  EXPECT_NEAR(rankOf(path_lengths), 0.5 * ideal, 1e-9);
}

// The printed second factor of Eq. 2 compares the rest of a leg's way, which is the torso, with a
// leg. The legs then want the origin in the neck.
TEST(LabelRanking, LegsRankTheIdealOriginFirstOnlyWithTheTorsosLength) {
  const auto legs = [](double up, const PoseTreeOptions& options) {
    auto path_lengths = idealPathLengths(2.0);
    for (size_t i = 3; i <= 4; ++i) path_lengths[i] = withOriginMoved(up)[i];
    return rankOf(path_lengths, 4, options);
  };
  PoseTreeOptions printed;
  printed.leg_rank = "printed";
  for (const double step : {0.02, 0.05, 0.1, 0.2}) {
    EXPECT_LT(legs(step, {}), legs(0.0, {})) << step;
    EXPECT_LT(legs(-step, {}), legs(0.0, {})) << step;
    EXPECT_GT(legs(step, printed), legs(0.0, printed)) << step;
  }
}

TEST(LabelRanking, DrawnTreeIsNamedAndRanksAlikeAtTwoPitches) {
  std::vector<double> ranks;
  for (const double pitch : {0.01, 0.02}) {
    const TreeGraph graph = makeTreeGraph(idealSkeleton(1.6, pitch), 0.15, 0.12);
    const LabelChoice choice = labelByRank(graph, pruned(0.08), {});
    ASSERT_EQ(choice.status, TreeStatus::kOk);
    const auto at = [&](UnsidedExtremity end) {
      return graph.positions[size_t(choice.extremities[size_t(end)])];
    };
    EXPECT_GT(at(UnsidedExtremity::kHead).z(), 1.2);
    EXPECT_LT(at(UnsidedExtremity::kFoot1).z(), 0.2);
    EXPECT_LT(at(UnsidedExtremity::kFoot2).z(), 0.2);
    EXPECT_GT(std::abs(at(UnsidedExtremity::kHand1).y()), 0.5);
    EXPECT_LT(at(UnsidedExtremity::kHand1).y() * at(UnsidedExtremity::kHand2).y(), 0.0);
    EXPECT_NEAR(choice.longest, 1.6, 0.06);
    ranks.push_back(choice.rank);
  }
  EXPECT_GT(ranks[0], 0.3);
  EXPECT_NEAR(ranks[0], ranks[1], 0.25 * ranks[0]);
}

TEST(LabelRanking, NearestOfTheLastFrameTakesTheName) {
  const TreeGraph graph = makeTreeGraph(idealSkeleton(1.6, 0.02), 0.15, 0.12);
  const LabelChoice alone = labelByRank(graph, pruned(0.08), {});
  std::array<Eigen::Vector3d, kUnsidedExtremityCount> last;
  for (size_t i = 0; i < last.size(); ++i) last[i] = graph.positions[size_t(alone.extremities[i])];
  std::swap(last[1], last[2]);
  std::swap(last[3], last[4]);
  const LabelChoice followed = labelByRank(graph, pruned(0.08), last);
  EXPECT_EQ(followed.extremities[1], alone.extremities[2]);
  EXPECT_EQ(followed.extremities[3], alone.extremities[4]);
}

TEST(LabelRanking, LineHasTooFewBranches) {
  TreeFigure figure(0.02);
  figure.line({0, 0, 0.2}, {0, 0, 1.6});
  const LabelChoice choice =
      labelByRank(makeTreeGraph(figure.skeleton(), 0.15, 0.12), pruned(0.08), {});
  EXPECT_EQ(choice.status, TreeStatus::kTooFewBranches);
  EXPECT_NE(choice.reason.find("2 extremities"), std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
