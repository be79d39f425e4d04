#include "markerless_mocap/hsiao/hsiao_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

TEST(HsiaoLimits, AreThoseOfTheThesis) {
  // Hsiao 2008, Table 3-4: theta_1 to theta_16, degrees.
  constexpr double kTable[kHsiaoAngles][2] = {{-90, 90},  {-90, 90},  {-180, 180}, {-180, 180},
                                              {-180, 90}, {-90, 180}, {-90, 135},  {-135, 90},
                                              {-180, 0},  {0, 180},   {-60, 90},   {-90, 60},
                                              {-180, 90}, {-180, 90}, {0, 180},    {0, 180}};
  const HsiaoLimits limits = HsiaoLimits::fromThesis();
  for (int k = 0; k < kHsiaoAngles; ++k) {
    EXPECT_NEAR(limits.lower[k], kTable[k][0] * M_PI / 180, 1e-12) << "theta " << k + 1;
    EXPECT_NEAR(limits.upper[k], kTable[k][1] * M_PI / 180, 1e-12) << "theta " << k + 1;
  }
}

TEST(HsiaoOptions, LimitAboveItsOtherEndIsAnError) {
  HsiaoOptions options;
  options.joint_limits.lower[15] = 1.0;
  options.joint_limits.upper[15] = 0.5;
  EXPECT_EQ(errorTextOf([&] { options.validate(); }),
            "pose_fitting/hsiao/joint_limits/right_knee is [1, 0.5], allowed is [min, max] with a "
            "min that is not greater than max");
}

TEST(HsiaoOptions, LimitsAreReadByJoint) {
  const HsiaoOptions options = loadOptions<HsiaoOptions>(
      YAML::Load("joint_limits: {neck_x: [-0.1, 0.2], right_knee: [0.3, 0.4]}"));
  EXPECT_EQ(options.joint_limits.lower[0], -0.1);
  EXPECT_EQ(options.joint_limits.upper[0], 0.2);
  EXPECT_EQ(options.joint_limits.lower[15], 0.3);
  EXPECT_EQ(options.joint_limits.upper[15], 0.4);
  EXPECT_EQ(options.joint_limits.lower[1], HsiaoLimits::fromThesis().lower[1]);
}

}  // namespace
}  // namespace markerless_mocap
