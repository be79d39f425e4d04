#include "contour/model/angle_ranges.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;

TEST(AngleRangesTest, AreTheLimitsOfTheUrdf) {
  const auto model = initialBody(PersonResources::standard(), 1.75)->model;
  const std::vector<std::pair<A::Id, std::string>> joints = {
      {A::kSpinePitch, "waist"},
      {A::kSpineRoll, "r_waist"},
      {A::kLeftClavicleYaw, "l_y_clavicle"},
      {A::kLeftClavicleRoll, "l_r_clavicle"},
      {A::kRightClavicleYaw, "r_y_clavicle"},
      {A::kRightClavicleRoll, "r_r_clavicle"},
      {A::kLeftElbow, "l_elbow"},
      {A::kRightElbow, "r_elbow"},
      {A::kLeftKnee, "l_knee"},
      {A::kRightKnee, "r_knee"},
      {A::kLeftAnkle, "l_ankle"},
      {A::kRightAnkle, "r_ankle"}};
  EXPECT_EQ(joints.size(), size_t(A::kCount) - 1);  // the URDF has no spine twist
  for (const auto& [angle, name] : joints) {
    EXPECT_DOUBLE_EQ(kAngleRanges[angle].lower, model->joint(name).lower) << name;
    EXPECT_DOUBLE_EQ(kAngleRanges[angle].upper, model->joint(name).upper) << name;
  }
}

}  // namespace
}  // namespace markerless_mocap
