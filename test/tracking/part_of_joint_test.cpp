#include "tracking/part_of_joint.h"

#include <gtest/gtest.h>

#include "body/body_fixture.h"

namespace markerless_mocap {
namespace {

TEST(PartOfJoint, JointsBelongToParts) {
  EXPECT_EQ(partOfJoint("r_head"), PartLabel::kHead);  // the head's roll, not a right limb
  EXPECT_EQ(partOfJoint("l_r_shoulder"), PartLabel::kArm1);
  EXPECT_EQ(partOfJoint("r_y_shoulder"), PartLabel::kArm2);
  EXPECT_EQ(partOfJoint("l_p_hip"), PartLabel::kLeg1);
  EXPECT_EQ(partOfJoint("r_knee"), PartLabel::kLeg2);
  EXPECT_EQ(partOfJoint("r_waist"), PartLabel::kTorso);
}

TEST(PartOfJoint, LinksBelongToThePartOfTheJointThatLeadsToThem) {
  const BodyModel& model = *testBody();
  EXPECT_EQ(partOfLink(model, 0), PartLabel::kTorso);
  EXPECT_EQ(partOfLink(model, model.linkIndex("l_elbow")), PartLabel::kArm1);
  EXPECT_EQ(partOfLink(model, model.linkIndex("r_knee")), PartLabel::kLeg2);
  EXPECT_EQ(partOfLink(model, model.linkIndex("head")), PartLabel::kHead);
}

}  // namespace
}  // namespace markerless_mocap
