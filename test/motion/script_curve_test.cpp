#include "motion/script/script_curve.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markerless_mocap {
namespace {

CurveValues one(double value) {
  return CurveValues::Constant(1, value);
}

ScriptCurve curve(const std::vector<std::pair<double, double>>& keys) {
  std::vector<CurveKey> list;
  for (const auto& [seconds, value] : keys) list.push_back({seconds, one(value)});
  return ScriptCurve(list);
}

TEST(ScriptCurve, goesThroughItsKeysAndRestsOutside) {
  const ScriptCurve c = curve({{1.0, 3.0}, {2.0, 5.0}, {4.0, -1.0}});
  EXPECT_DOUBLE_EQ(c.at(1.0)[0], 3.0);
  EXPECT_NEAR(c.at(2.0)[0], 5.0, 1e-12);
  EXPECT_DOUBLE_EQ(c.at(4.0)[0], -1.0);
  EXPECT_DOUBLE_EQ(c.at(0.0)[0], 3.0);
  EXPECT_DOUBLE_EQ(c.at(9.0)[0], -1.0);
}

TEST(ScriptCurve, twoKeysAreTheSmoothStep) {
  const ScriptCurve c = curve({{0.0, 0.0}, {2.0, 8.0}});
  EXPECT_NEAR(c.at(1.0)[0], 4.0, 1e-12);
  EXPECT_NEAR(c.at(0.5)[0], 8.0 * (3.0 * 0.0625 - 2.0 * 0.015625), 1e-12);
}

TEST(ScriptCurve, evenKeysInALineAreALineInTheMiddle) {
  const ScriptCurve c = curve({{0.0, 0.0}, {1.0, 2.0}, {2.0, 4.0}, {3.0, 6.0}});
  EXPECT_NEAR(c.at(1.25)[0], 2.5, 1e-12);
  EXPECT_NEAR(c.at(1.7)[0], 3.4, 1e-12);
}

TEST(ScriptCurve, neverOvershootsAndHasNoCorners) {
  const ScriptCurve c = curve({{0, 0}, {0.3, 10}, {0.4, 10.5}, {1.5, 10.6}, {1.6, -4}, {2, -4}});
  double last_slope = 0.0;
  for (double t = 0.0; t < 2.0; t += 1e-4) {
    EXPECT_GE(c.at(t)[0], -4.0 - 1e-9);
    EXPECT_LE(c.at(t)[0], 10.6 + 1e-9);
    if (t < 1.4999) {
      EXPECT_GE(c.at(t + 1e-4)[0], c.at(t)[0] - 1e-9);
    }
    const double slope = (c.at(t + 1e-4)[0] - c.at(t)[0]) / 1e-4;
    EXPECT_LT(std::abs(slope - last_slope), 2.0) << t;
    last_slope = slope;
  }
}

TEST(ScriptCurve, refusesTimesThatDoNotRise) {
  EXPECT_THROW(curve({{1.0, 0.0}, {1.0, 1.0}}), std::invalid_argument);
  EXPECT_THROW(ScriptCurve(std::vector<CurveKey>{}), std::invalid_argument);
  EXPECT_THROW(ScriptCurve({{0.0, one(1.0)}, {1.0, CurveValues::Zero(2)}}), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
