#include "markerless_mocap/hsiao/hsiao_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

HsiaoOptions profileFile() {
  const YAML::Node file = YAML::LoadFile(MOCAP_SOURCE_DIR "/config/hsiao_profile.yaml");
  return loadOptions<HsiaoOptions>(file[HsiaoOptions::kStage]);
}

TEST(HsiaoProfileFile, HoldsTheLimitsOfTheThesis) {
  const HsiaoLimits file = profileFile().limits, fromThesis = HsiaoLimits::fromThesis();
  for (int k = 0; k < kHsiaoAngles; ++k) {
    EXPECT_NEAR(file.lower[k], fromThesis.lower[k], 1e-4) << "theta " << k + 1;
    EXPECT_NEAR(file.upper[k], fromThesis.upper[k], 1e-4) << "theta " << k + 1;
  }
}

TEST(HsiaoLimits, ElbowsAndKneesBendOneWay) {
  const HsiaoLimits limits = HsiaoLimits::fromThesis();
  EXPECT_EQ(limits.upper[8], 0.0);   // theta_9, left elbow: [-pi, 0]
  EXPECT_EQ(limits.lower[9], 0.0);   // theta_10, right elbow: [0, pi]
  EXPECT_EQ(limits.lower[14], 0.0);  // knees: [0, pi]
  EXPECT_EQ(limits.lower[15], 0.0);
  EXPECT_DOUBLE_EQ(limits.lower[10], -M_PI / 3);  // left hip outwards and inwards
  EXPECT_DOUBLE_EQ(limits.upper[11], M_PI / 3);
}

TEST(HsiaoOptions, RefusesALimitAboveItsOtherEnd) {
  HsiaoOptions options;
  options.limits.lower[15] = 1.0;
  options.limits.upper[15] = 0.5;
  const std::string sentence = errorTextOf([&] { options.validate(); });
  EXPECT_NE(sentence.find("pose_fitting/right_knee_lowest is 1.0"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace markerless_mocap
