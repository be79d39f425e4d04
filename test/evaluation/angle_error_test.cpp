#include "evaluation/angle_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace markerless_mocap {
namespace {

TEST(AngleError, WrapsAround) {
  EXPECT_NEAR(angleBetween(3.1, -3.1), 2 * M_PI - 6.2, 1e-12);
  EXPECT_NEAR(angleBetween(0.2 + 4 * M_PI, -0.1), 0.3, 1e-12);
  EXPECT_NEAR(angleBetween(0, M_PI), M_PI, 1e-12);
}

TEST(AngleError, IsPerJointOverTheMatchedFrames) {
  const std::vector<AngleFrame> truth{
      {0, {{"knee", 0.0}, {"neck", 1.0}}}, {1, {{"knee", 3.1}}}, {2, {{"knee", 0.5}}}};
  const std::vector<AngleFrame> found{{0, {{"knee", 0.1}, {"elbow", 9}}}, {1, {{"knee", -3.1}}}};
  const auto errors = angleErrors(truth, found, {0, 1, -1});
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].joint, "knee");
  EXPECT_EQ(errors[0].error_deg.count, 2u);
  EXPECT_NEAR(errors[0].error_deg.max, 0.1 * 180 / M_PI, 1e-9);
  EXPECT_NEAR(errors[0].error_deg.mean, (0.1 + 2 * M_PI - 6.2) / 2 * 180 / M_PI, 1e-9);
}

}  // namespace
}  // namespace markerless_mocap
