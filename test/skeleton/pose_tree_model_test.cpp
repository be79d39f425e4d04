#include "markerless_mocap/skeleton/pose_tree_model.h"

#include <gtest/gtest.h>

#include "error_text_of.h"
#include "markerless_mocap/skeleton/pose_tree_builder.h"
#include "resources/resources.h"
#include "skeleton/labelling/extremity_label_model.h"
#include "skeleton/labelling/validity_model.h"
#include "skeleton/tree_figure.h"

namespace markerless_mocap {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

std::string errorOf(const std::string& extremities, const std::string& validity) {
  return errorTextOf([&] {
    PoseTreeModel::fromYaml({extremities, "ends.yaml"}, {validity, "validity.yaml"});
  });
}

std::string errorOfExtremities(const std::string& what, const std::string& with) {
  return errorOf(replaced(poseTreeExtremitiesYaml(), what, with), poseTreeValidityYaml());
}

std::string errorOfValidity(const std::string& what, const std::string& with) {
  return errorOf(poseTreeExtremitiesYaml(), replaced(poseTreeValidityYaml(), what, with));
}

TEST(PoseTreeModel, HasTheNumbersOfTheFilesUnderTheirNames) {
  const ExtremityLabelModel& ends = PoseTreeModel::standard().extremities();
  EXPECT_EQ(ends.extremities[0].constant, -3.99);
  EXPECT_EQ(ends.extremities[1].constant, 0.30);
  EXPECT_EQ(ends.extremities[2].curves[kEndReach].knots,
            (std::vector<double>{-1.39, -1.36, -1.26, -1.18, -0.43, 1.63, 3.99}));
  EXPECT_EQ(ends.no_body_log_odds, 1.86);
  const PiecewiseLinear& together = ends.body.curves[kFeetTogether];
  EXPECT_EQ(together.low, 0.0);
  EXPECT_EQ(together.high, 1.0);
  EXPECT_EQ(together.knots, (std::vector<double>{1.18, -2.2}));
  EXPECT_EQ(ends.body(kFeetTogether, 0.5), 1.18 + 0.5 * (-2.2 - 1.18));
  const ValidityModel& validity = PoseTreeModel::standard().validity();
  EXPECT_EQ(validity.intercept, -6.02);
  EXPECT_EQ(validity.curves[kHeadRadius].low, 0.0032);
  EXPECT_EQ(validity.curves[kHeadRadius].high, 0.0438);
  EXPECT_EQ(validity.curves[kHeadRadius].knots,
            (std::vector<double>{0.16, 0.06, -0.02, -0.06, -0.15}));
}

TEST(PoseTreeModel, BuilderLabelsByTheModelItIsGiven) {
  const VisualHull hull = personHull(FigurePose(), 0.0156);
  EXPECT_EQ(PoseTreeBuilder(PoseTreeOptions()).build(hull).status, TreeStatus::kOk);
  const PoseTreeModel doubtful = PoseTreeModel::fromYaml(
      {poseTreeExtremitiesYaml(), "ends.yaml"},
      {replaced(poseTreeValidityYaml(), "intercept: -6.02", "intercept: -60"), "validity.yaml"});
  const PoseTree tree = PoseTreeBuilder(PoseTreeOptions(), doubtful).build(hull);
  EXPECT_EQ(tree.status, TreeStatus::kUncertain);
  EXPECT_LT(tree.validity, 1e-9);
}

TEST(PoseTreeModel, MissingKeysAreNamed) {
  EXPECT_EQ(errorOfValidity("intercept: -6.02\n", ""), "validity.yaml: key 'intercept' is missing");
  EXPECT_EQ(errorOfValidity("  head_below:", "  head_above:"),
            "validity.yaml, curves: key 'head_below' is missing");
  EXPECT_EQ(errorOfExtremities("  foot:", "  paw:"),
            "ends.yaml, extremities: key 'foot' is missing");
  EXPECT_EQ(errorOfExtremities("end_up: {low: 0, ", "end_up: {"),
            "ends.yaml, extremities, head, curves, end_up: key 'low' is missing");
  EXPECT_EQ(errorOfExtremities("no_body_log_odds: 1.86", "no_body: 1.86"),
            "ends.yaml, body: key 'no_body_log_odds' is missing");
}

TEST(PoseTreeModel, KeysThatNobodyKnowsAndDoubledOnesAreNamed) {
  EXPECT_EQ(errorOfValidity("curves:\n", "curves:\n  tail: {low: 0, high: 1, knots: [0, 1]}\n")
                .rfind("validity.yaml, curves: key 'tail' is unknown, allowed are ", 0),
            0u);
  EXPECT_EQ(errorOfValidity("intercept: -6.02\n", "intercept: -6.02\nintercept: 1\n"),
            "validity.yaml: key 'intercept' is repeated");
  EXPECT_EQ(errorOfExtremities("end_cut: {low: 0, ", "end_cut: {low: 0, middle: 1, "),
            "ends.yaml, extremities, head, curves, end_cut: key 'middle' is unknown, allowed are "
            "high, knots, low");
}

TEST(PoseTreeModel, NumbersMustBeFiniteAndEnough) {
  const std::string curve = "validity.yaml, curves, feet_are_one: ";
  EXPECT_EQ(errorOfValidity("[1.26, -1.27]", "[1.26]"),
            curve + "'knots' must be at least two numbers");
  EXPECT_EQ(errorOfValidity("[1.26, -1.27]", "[1.26, .nan]"),
            curve + "'knots' holds .nan, allowed are finite numbers");
  EXPECT_EQ(errorOfValidity("[1.26, -1.27]", "[1.26, much]"),
            curve + "'knots' holds much, allowed are finite numbers");
  EXPECT_EQ(errorOfValidity("[1.26, -1.27]", "1.26"), curve + "'knots' is no list of numbers");
  EXPECT_EQ(errorOfValidity("intercept: -6.02", "intercept: .inf"),
            "validity.yaml: 'intercept' holds .inf, allowed are finite numbers");
  EXPECT_EQ(errorOfExtremities("constant: -5.59", "constant: .nan"),
            "ends.yaml, extremities, foot: 'constant' holds .nan, allowed are finite numbers");
  EXPECT_EQ(errorOfExtremities("end_cut: {low: 0, high: 1,", "end_cut: {low: 1, high: 1,"),
            "ends.yaml, extremities, head, curves, end_cut: 'high' must be above 'low'");
}

TEST(PoseTreeModel, WhatIsNoMapIsSaid) {
  EXPECT_EQ(errorOf("3", poseTreeValidityYaml()), "ends.yaml: this is no map of keys to values");
  EXPECT_EQ(errorOf("", poseTreeValidityYaml()), "ends.yaml: this is no map of keys to values");
  EXPECT_EQ(errorOf("a: [", poseTreeValidityYaml()).find("ends.yaml is no YAML: "), 0u);
  EXPECT_EQ(errorOf(poseTreeExtremitiesYaml(), "intercept: 1\ncurves: 2\n"),
            "validity.yaml, curves: this is no map of keys to values");
}

}  // namespace
}  // namespace markerless_mocap
