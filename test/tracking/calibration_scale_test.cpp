#include "tracking/calibration_scale.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

TEST(CalibrationScale, APersonOfImpossibleStatureTellsOfTheScale) {
  EXPECT_EQ(scaleFinding(1.95), "");
  EXPECT_EQ(scaleFinding(1.1), "") << "a child";
  const std::string large = scaleFinding(2.5);
  EXPECT_NE(large.find("2.50 m tall in it, so its metre is too short"), std::string::npos) << large;
  EXPECT_NE(large.find("multiplied by 0.70"), std::string::npos) << large;
  EXPECT_NE(scaleFinding(0.9).find("too long"), std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
