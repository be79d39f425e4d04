#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>

#include "markerless_mocap/pipeline/make_body_tracker.h"
#include "pipeline/drawn_walk.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame_ns = 33333333;

const char* const kOnce = "a person was found, but another frame must confirm the pose";

/// The masks with holes and specks, others in every frame.
std::vector<cv::Mat> spoilt(int frame) {
  constexpr int kSpots = 16;
  std::mt19937 random(unsigned(frame) + 1);
  const auto below = [&](int count) { return int(random() % unsigned(count)); };
  std::vector<cv::Mat> masks;
  for (const cv::Mat& whole : masksAt(frame)) {
    cv::Mat mask = whole.clone();
    std::vector<cv::Point> person;
    cv::findNonZero(whole, person);
    for (int i = 0; i < kSpots; ++i) {
      const cv::Point hole = person[size_t(below(int(person.size())))];
      cv::circle(mask, hole, 1 + below(5), cv::Scalar(0), cv::FILLED);
      const cv::Point speck = person[size_t(below(int(person.size())))];
      cv::circle(mask, speck + cv::Point(below(21) - 10, below(21) - 10), 1 + below(3),
                 cv::Scalar(255), cv::FILLED);
    }
    masks.push_back(mask);
  }
  return masks;
}

/// The tree of one who is turned by a right angle, which tells itself that it is not sure.
PoseTree sidewaysTree(int frame) {
  ContourPose pose = at(frame);
  pose.rotations[SphericalJoint::kRoot] =
      expSO3({0, 0, M_PI / 2}) * pose.rotations[SphericalJoint::kRoot];
  PoseTree tree = treeOf(ContourBody(truth()), pose, false);
  tree.status = TreeStatus::kUncertain;
  return tree;
}
PoseTree rightTree(int frame) {
  PoseTree tree = treeOf(ContourBody(truth()), at(frame), false);
  tree.status = TreeStatus::kUncertain;
  return tree;
}

class ContourStartTest : public testing::Test {
 protected:
  ContourStartTest() {
    resources.urdf_template = humanTemplate();
    resources.known_shape = truth();
    options.contour.rays = 400;
    options.person.shape_poses = 6;
  }
  void make() { tracker = makeBodyTracker(drawnRig(5), resources, options); }
  BodyPose show(int frame, const std::vector<cv::Mat>& masks, const PoseTree& tree) {
    ReadyProducts products({hull, parts, tree});
    return tracker->update(
        {(frame + 1) * kFrame_ns, masks, {}, products, [this] { return behind; }, images_awaited});
  }
  double error(const BodyPose& pose, int frame) const {
    return errorOf(*tracker->body()->model, pose, frame);
  }

  PersonResources resources;
  TrackerOptions options;
  VisualHull hull;  // empty, and so are the parts: the tree and the masks must do
  BodyParts parts;
  bool behind = false, images_awaited = false;
  std::unique_ptr<BodyTracker> tracker;
};

TEST_F(ContourStartTest, SpoiltMasksAreBelievedWhenALaterInstantShowsTheSame) {
  make();
  EXPECT_EQ(show(0, spoilt(0), rightTree(0)).reason, kOnce);
  for (const int frame : {1, 2, 3})
    EXPECT_EQ(show(frame, spoilt(frame), PoseTree{}).status, PoseStatus::kLost)
        << frame << ": following is not finding again";
  const BodyPose pose = show(4, spoilt(4), rightTree(4));
  EXPECT_EQ(pose.status, PoseStatus::kReinitialized) << pose.reason;
  EXPECT_LT(error(pose, 4), 0.04);
  EXPECT_EQ(show(5, spoilt(5), PoseTree{}).status, PoseStatus::kTracked) << "decided once";
}

TEST_F(ContourStartTest, WhileNewerInstantsWaitNobodyIsLookedForAgain) {
  make();
  EXPECT_EQ(show(0, spoilt(0), rightTree(0)).reason, kOnce);
  behind = true;
  for (const int frame : {1, 2, 3, 4, 5, 6})
    EXPECT_EQ(show(frame, spoilt(frame), rightTree(frame)).reason, kOnce) << frame;
  behind = false;
  EXPECT_EQ(show(7, spoilt(7), rightTree(7)).status, PoseStatus::kReinitialized)
      << "put off, but not forgotten";
}

TEST_F(ContourStartTest, AStartWaitsForImagesThatHaveBeenAskedForAndFollowingDoesNot) {
  make();
  images_awaited = true;
  const BodyPose pose = show(0, masksAt(0), rightTree(0));
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "images of cameras whose background is not known have been asked for");
  images_awaited = false;
  EXPECT_EQ(show(1, masksAt(1), rightTree(1)).status, PoseStatus::kReinitialized);
  images_awaited = true;
  EXPECT_EQ(show(2, masksAt(2), PoseTree{}).status, PoseStatus::kTracked);
}

TEST_F(ContourStartTest, AWrongStartIsLeftForABetterOneAndNeverClaimed) {
  make();
  EXPECT_EQ(show(0, spoilt(0), sidewaysTree(0)).status, PoseStatus::kLost);
  int claimed = 0;
  for (int frame = 1; frame <= 6; ++frame) {
    const BodyPose pose = show(frame, spoilt(frame), rightTree(frame));
    if (pose.status == PoseStatus::kLost) continue;
    ++claimed;
    EXPECT_LT(error(pose, frame), 0.05) << frame;
  }
  EXPECT_GE(claimed, 2) << "within a sixth of a second";
}

TEST_F(ContourStartTest, OneWhoseHullTellsNoPartsIsFoundAllTheSame) {
  make();
  hull.lattice.origin = at(0).position;
  hull.lattice.pitch = 0.1;
  hull.lattice.size = {1, 1, 1};
  hull.voxels.resize(1);
  const BodyPose pose = show(0, masksAt(0), PoseTree{});
  EXPECT_EQ(pose.status, PoseStatus::kReinitialized) << pose.reason;
  EXPECT_LT(error(pose, 0), 0.12) << "an arm may still be elsewhere";
}

TEST_F(ContourStartTest, StartsThatFindOtherBodiesEachAreNotBelieved) {
  make();
  for (int frame = 0; frame <= 4; ++frame) {
    PoseTree tree = frame % 4 ? PoseTree{} : sidewaysTree(frame);
    const BodyPose pose = show(frame, spoilt(frame), frame == 4 ? rightTree(4) : tree);
    EXPECT_EQ(pose.status, PoseStatus::kLost) << frame << ", " << error(pose, frame);
  }
}

TEST_F(ContourStartTest, APersonWithFurnitureIsNeverClaimed) {
  make();
  for (int frame = 0; frame <= 8; frame += 2) {
    std::vector<cv::Mat> masks = masksAt(0);  // a still scene confirms itself
    for (cv::Mat& mask : masks) {
      mask = mask.clone();
      cv::Rect chair = cv::boundingRect(mask);
      chair.y += chair.height / 2;
      chair.height -= chair.height / 2;
      mask(chair).setTo(255);
    }
    const BodyPose pose = show(frame, masks, rightTree(0));
    EXPECT_EQ(pose.status, PoseStatus::kLost) << pose.silhouette_overlap;
    EXPECT_EQ(pose.reason.find("no pose covers the silhouettes, the best overlap is 0."), 0u)
        << pose.reason;
  }
}

TEST_F(ContourStartTest, ABodyIsNotMeasuredFromWhatIsNotDecided) {
  resources.known_shape.reset();
  make();
  const BodyPose undecided = show(0, spoilt(0), rightTree(0));
  EXPECT_EQ(undecided.status, PoseStatus::kLost);
  EXPECT_EQ(undecided.reason, "a person was found, but another frame must confirm the pose");
  BodyPose pose;
  for (const int frame : {2, 4, 6}) pose = show(frame, spoilt(frame), rightTree(frame));
  EXPECT_NE(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "the body is being measured, 2 of 6 different poses have been seen")
      << "only from frames after the decision";
}

}  // namespace
}  // namespace markerless_mocap
