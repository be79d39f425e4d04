#include "skeleton/labelling/validity_features.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "skeleton/labelling.h"
#include "skeleton/labelling/validity_model.h"
#include "skeleton/thinner.h"
#include "skeleton/tree_figure.h"

namespace markerless_mocap {
namespace {

struct Labelled {
  PoseTree tree;
  std::optional<ValidityFeatures> features;
};

Labelled labelled(const VisualHull& hull) {
  const PoseTreeOptions options;
  Labelling labelling(options, PoseTreeModel::standard(), hull,
                      Thinner(PoseTreeOptions().persistence).thin(hull));
  PreviousExtremities ends;
  Labelled out;
  out.tree = labelling.run({}, &ends);
  out.features = labelling.features();
  return out;
}

TEST(ValidityFeatures, MeasuresOfAStandingFigureAreThose) {
  const Labelled found = labelled(personHull(FigurePose(), 0.0156));
  ASSERT_TRUE(found.features) << found.tree.reason;
  const ValidityFeatures& features = *found.features;
  EXPECT_GT(features[kArmsAcross], 0.98);  // one arm is straight left of the other
  EXPECT_GT(features[kLegsAgree], 0.9);
  EXPECT_GT(features[kHeadUpright], 0.98);
  EXPECT_NEAR(features[kHeadBelow], 0.0, 0.01);
  EXPECT_NEAR(features[kLowFootUp], 0.0, 0.01);
  EXPECT_GT(features[kFeetForward], 0.02);
  EXPECT_EQ(features[kFeetAreOne], 0.0);
  EXPECT_GE(features[kLongerArm], features[kShorterArm]);
  // In metres: what the features are shares of is the same for all of them.
  const double longest = 0.36 / features[kFeetGap];
  EXPECT_NEAR(longest, 2.3, 0.25);
  EXPECT_NEAR(features[kHandNear] * longest, 0.66, 0.08);
  EXPECT_NEAR(features[kShankRadius] * longest, 0.055, 0.02);
  EXPECT_EQ(found.tree.validity, PoseTreeModel::standard().validity().probability(features));
}

TEST(ValidityFeatures, MirrorChangesThemLittle) {
  FigurePose pose;
  pose.left_hand = {0.3, 0.5, 1.6};
  const Labelled one = labelled(personHull(pose, 0.0156));
  const Labelled other = labelled(personHull(mirrored(pose), 0.0156));
  ASSERT_TRUE(one.features && other.features);
  for (int i = kArmsOffset; i < kValidityFeatureCount; ++i)
    EXPECT_NEAR((*one.features)[size_t(i)], (*other.features)[size_t(i)], 0.03)
        << toString(ValidityFeature(i));
}

TEST(ValidityFeatures, FeetOnOneSpotAreOne) {
  FigurePose pose;
  pose.left_ankle = {0, 0.03, 0.09};
  pose.right_ankle = {0, -0.03, 0.09};
  pose.left_knee = {0.03, 0.05, 0.5};
  pose.right_knee = {0.03, -0.05, 0.5};
  const Labelled found = labelled(personHull(pose, 0.0156));
  ASSERT_TRUE(found.features) << found.tree.reason;
  EXPECT_EQ((*found.features)[kFeetAreOne], 1.0);
  EXPECT_EQ((*found.features)[kLegsOffset], 0.0);
}

TEST(ValidityFeatures, LineHasNone) {
  TreeFigure figure(0.0156);
  figure.capsule({0, 0, 0.2}, {0, 0, 1.7}, 0.12);
  EXPECT_FALSE(labelled(figure.hull()).features);
}

TEST(ValidityFeatures, SurerNamesAndAHeadOnTopMakeItMoreValid) {
  const ValidityModel& model = PoseTreeModel::standard().validity();
  ValidityFeatures features = *labelled(personHull(FigurePose(), 0.0156)).features;
  double last = 0.0;
  for (const double odds : {-8.0, -2.0, 2.0, 6.0}) {
    features[kNamesOdds] = odds;
    EXPECT_GT(model.probability(features), last) << odds;
    last = model.probability(features);
  }
  EXPECT_GT(last, 0.9);
  EXPECT_LT(last, 1.0);
  features[kHeadBelow] = 0.15;
  EXPECT_LT(model.probability(features), last);
}

TEST(ValidityFeatures, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int i = 0; i < kValidityFeatureCount; ++i) names.insert(toString(ValidityFeature(i)));
  EXPECT_EQ(names.size(), size_t(kValidityFeatureCount));
}

}  // namespace
}  // namespace markerless_mocap
