#include <gtest/gtest.h>

#include "contour/contour_tracker.h"
#include "contour/counted_proposals.h"
#include "contour/drawn_body.h"
#include "markerless_mocap/tracking/shape_file.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {
namespace {

class StatureTest : public testing::TestWithParam<double> {};
// A child, people, and somebody in a calibration whose metre is too short.
INSTANTIATE_TEST_SUITE_P(Metres, StatureTest, testing::Values(1.15, 1.6, 1.9, 2.35));

TEST_P(StatureTest, IsFoundWithoutBeingGiven) {
  const double stature = GetParam();
  const CameraRig rig = drawnRig(4);
  const ContourBody body(ShapeStatistics::handMade().meanShape(stature));
  ContourPose pose = stride();
  pose.position.z() *= stature / 1.75;
  int proposals = 0;
  PersonOptions person;
  person.measure = true;
  ContourTracker tracker(rig, PersonResources::standard(), person, ContourOptions(),
                         [&](std::shared_ptr<const BodyModel> model) {
                           return std::make_unique<CountedProposals>(model, pose, &proposals);
                         });
  ReadyProducts products;
  for (int64_t frame = 0; frame < 5; ++frame) {
    pose.angles[RevoluteJoint::kLeftElbow] += 0.1;
    tracker.update({1 + frame * 100000000, drawnMasks(rig, body, pose), {}, products});
  }
  tracker.estimateShapeNow();
  ASSERT_TRUE(tracker.body()->shape_estimated);
  EXPECT_NEAR(statureOf(tracker.body()->shape), stature, 0.04 * stature);
}

}  // namespace
}  // namespace markerless_mocap
