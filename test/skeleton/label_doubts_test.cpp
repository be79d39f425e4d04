#include "skeleton/labelling/label_doubts.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "markerless_mocap/skeleton/thinner.h"
#include "skeleton/labelling.h"
#include "skeleton/tree_figure.h"

namespace markerless_mocap {
namespace {

struct Labelled {
  PoseTree tree;
  std::optional<LabelDoubts> doubts;
};

Labelled labelled(const VisualHull& hull) {
  const PoseTreeOptions options;
  Labelling labelling(options, hull, Thinner(kTreePersistence).thin(hull));
  LastEnds ends;
  Labelled out;
  out.tree = labelling.run({}, &ends);
  out.doubts = labelling.doubts();
  return out;
}

TEST(LabelDoubts, MeasuresOfAStandingFigureAreThose) {
  const Labelled found = labelled(personHull(FigurePose(), 0.0156));
  ASSERT_TRUE(found.doubts) << found.tree.reason;
  const LabelDoubts& doubts = *found.doubts;
  EXPECT_GT(doubts[kArmsAcross], 0.98);  // one arm is straight left of the other
  EXPECT_GT(doubts[kLegsAgree], 0.9);
  EXPECT_GT(doubts[kHeadUpright], 0.98);
  EXPECT_NEAR(doubts[kHeadBelow], 0.0, 0.01);
  EXPECT_NEAR(doubts[kLowFootUp], 0.0, 0.01);
  EXPECT_GT(doubts[kFeetForward], 0.02);
  EXPECT_EQ(doubts[kFeetAreOne], 0.0);
  EXPECT_GE(doubts[kLongerArm], doubts[kShorterArm]);
  // In metres: what the doubts are shares of is the same for all of them.
  const double longest = 0.36 / doubts[kFeetGap];
  EXPECT_NEAR(longest, 2.3, 0.25);
  EXPECT_NEAR(doubts[kHandNear] * longest, 0.66, 0.08);
  EXPECT_NEAR(doubts[kShankRadius] * longest, 0.055, 0.02);
  EXPECT_EQ(found.tree.validity, validityOf(doubts));
}

TEST(LabelDoubts, MirrorChangesThemLittle) {
  FigurePose pose;
  pose.left_hand = {0.3, 0.5, 1.6};
  const Labelled one = labelled(personHull(pose, 0.0156));
  const Labelled other = labelled(personHull(mirrored(pose), 0.0156));
  ASSERT_TRUE(one.doubts && other.doubts);
  for (int i = kArmsOffset; i < kLabelDoubtCount; ++i)
    EXPECT_NEAR((*one.doubts)[size_t(i)], (*other.doubts)[size_t(i)], 0.03)
        << toString(LabelDoubt(i));
}

TEST(LabelDoubts, FeetOnOneSpotAreOne) {
  FigurePose pose;
  pose.left_ankle = {0, 0.03, 0.09};
  pose.right_ankle = {0, -0.03, 0.09};
  pose.left_knee = {0.03, 0.05, 0.5};
  pose.right_knee = {0.03, -0.05, 0.5};
  const Labelled found = labelled(personHull(pose, 0.0156));
  ASSERT_TRUE(found.doubts) << found.tree.reason;
  EXPECT_EQ((*found.doubts)[kFeetAreOne], 1.0);
  EXPECT_EQ((*found.doubts)[kLegsOffset], 0.0);
}

TEST(LabelDoubts, LineHasNone) {
  TreeFigure figure(0.0156);
  figure.capsule({0, 0, 0.2}, {0, 0, 1.7}, 0.12);
  EXPECT_FALSE(labelled(figure.hull()).doubts);
}

TEST(LabelDoubts, SurerNamesAndAHeadOnTopMakeItMoreValid) {
  LabelDoubts doubts = *labelled(personHull(FigurePose(), 0.0156)).doubts;
  double last = 0.0;
  for (const double odds : {-8.0, -2.0, 2.0, 6.0}) {
    doubts[kNamesOdds] = odds;
    EXPECT_GT(validityOf(doubts), last) << odds;
    last = validityOf(doubts);
  }
  EXPECT_GT(last, 0.9);
  EXPECT_LT(last, 1.0);
  doubts[kHeadBelow] = 0.15;
  EXPECT_LT(validityOf(doubts), last);
}

TEST(LabelDoubts, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int i = 0; i < kLabelDoubtCount; ++i) names.insert(toString(LabelDoubt(i)));
  EXPECT_EQ(names.size(), size_t(kLabelDoubtCount));
}

}  // namespace
}  // namespace markerless_mocap
