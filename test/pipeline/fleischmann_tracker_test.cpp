#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "error_text_of.h"
#include "fleischmann/appearance_scene.h"
#include "fleischmann/fleischmann_tracker.h"
#include "fleischmann/painted_person.h"
#include "hsiao/hsiao_pose_estimator.h"
#include "hsiao/model/hsiao_urdf_converter.h"
#include "hsiao/synthetic_person.h"
#include "markerless_mocap/pipeline/make_body_tracker.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame_ns = 1000000000 / 30;

/// Cameras around the place where synthetic people stand.
CameraRig rigAroundThePerson() {
  CameraRig rig;
  for (const Camera& camera : ringOfFour()) {
    CameraCalibration c = camera.calibration();
    c.T_world_camera.translation() += Eigen::Vector3d(1.0, 2.0, 0.0);
    rig.emplace_back(c);
  }
  return rig;
}

FleischmannMotionStatistics motion() {
  FleischmannMotionStatistics motion;
  motion.max_change.setConstant(0.05);
  motion.max_change.segment<3>(kPelvisPosition).setConstant(0.015);
  return motion;
}

std::unique_ptr<BodyTracker> trackerFor(const CameraRig& rig,
                                        const FleischmannMotionStatistics& motion) {
  return std::make_unique<FleischmannTracker>(
      rig, PersonResources::standard(), PersonOptions(), FleischmannOptions(), motion,
      [](std::shared_ptr<const BodyModel> model) {
        return std::make_unique<HsiaoPoseEstimator>(std::move(model), HsiaoOptions());
      });
}

/// What the stages make of a person.
struct Seen {
  std::vector<cv::Mat> masks, images;
  VisualHull hull;
  BodyParts parts;
  PoseTree tree;
};

class FleischmannTrackerTest : public testing::Test {
 protected:
  static HsiaoVector at(const HsiaoBodyModel& profile, int frame) {
    HsiaoVector v = stepping(profile, 0.3);
    v[0] += 0.02 * frame;
    v[3] += 0.02 * frame;
    v[hsiaoTheta(9)] -= 0.03 * frame;
    v[hsiaoTheta(14)] -= 0.04 * frame;
    return v;
  }

  void place(int frame, Eigen::Isometry3d& root, Eigen::VectorXd& angles) const {
    place(at(profile_, frame), root, angles);
  }
  void place(const HsiaoVector& v, Eigen::Isometry3d& root, Eigen::VectorXd& angles) const {
    HsiaoUrdfConverter conversion(body_, std::make_shared<HsiaoBodyModel>(*body_));
    conversion.convert(v, root, angles);
  }

  Seen see(int frame) const { return see(at(profile_, frame)); }
  Seen see(const HsiaoVector& pose) const {
    Eigen::Isometry3d root;
    Eigen::VectorXd angles;
    place(pose, root, angles);
    Seen seen;
    for (const FleischmannView& view : paintedViews(rig_, *body_, root, angles)) {
      seen.masks.push_back(view.silhouette);
      seen.images.push_back(view.image);
    }
    seen.hull = hullOf(profile_, shape_, pose);
    seen.parts = curvesOf(profile_, pose);
    return seen;
  }

  /// What part curves and hull do not tell.
  Seen seeMasks(int frame) const {
    Seen seen = see(frame);
    seen.parts = BodyParts();
    seen.parts.reason = "no body is recognised";
    return seen;
  }

  BodyPose show(const Seen& seen, int64_t stamp_ns) {
    ReadyProducts products({seen.hull, seen.parts, seen.tree});
    return tracker_->update({stamp_ns, seen.masks, seen.images, products});
  }
  BodyPose show(const Seen& seen) { return show(seen, stamp_ += kFrame_ns); }

  /// Mean distance of the fifteen markers, metres.
  double error(const BodyPose& pose, int frame) const { return error(pose, at(profile_, frame)); }
  double error(const BodyPose& pose, const HsiaoVector& v) const {
    Eigen::Isometry3d root;
    Eigen::VectorXd angles;
    place(v, root, angles);
    LinkPoses links, true_links;
    body_->forwardKinematics(pose.T_world_body, pose.angles, links);
    body_->forwardKinematics(root, angles, true_links);
    const auto found = markerPositions(*body_, links), truth = markerPositions(*body_, true_links);
    double sum = 0.0;
    for (size_t m = 0; m < found.size(); ++m) sum += (found[m] - truth[m]).norm();
    return sum / double(found.size());
  }

  std::shared_ptr<const BodyModel> body_ = testBody();
  HsiaoBodyModel profile_{*body_};
  HsiaoBodyShape shape_{*body_, profile_};
  CameraRig rig_ = rigAroundThePerson();
  std::unique_ptr<BodyTracker> tracker_ = trackerFor(rig_, motion());
  int64_t stamp_ = 0;
};

TEST_F(FleischmannTrackerTest, startsFromPartsAndFollowsByMasksAlone) {
  BodyPose pose = show(see(0));
  ASSERT_EQ(pose.status, PoseStatus::kReinitialized) << pose.reason;
  EXPECT_LT(error(pose, 0), 0.04);
  EXPECT_GT(pose.silhouette_overlap, 0.9);
  EXPECT_TRUE(std::isnan(pose.skeleton_error_m));
  for (int frame = 1; frame <= 5; ++frame) {
    Seen seen = seeMasks(frame);
    if (frame > 2) seen.images.assign(4, cv::Mat());
    pose = show(seen);
    EXPECT_EQ(pose.status, PoseStatus::kTracked) << pose.reason;
    EXPECT_LT(error(pose, frame), 0.05) << frame;
  }
  EXPECT_EQ(tracker_->body()->model->angleCount(), pose.angles.size());
  EXPECT_FALSE(tracker_->body()->shape_estimated);
}

TEST_F(FleischmannTrackerTest, saysThatThereIsNoPoseToStartFrom) {
  const BodyPose pose = show(seeMasks(0));
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "no start pose: no body is recognised");
}

TEST_F(FleischmannTrackerTest, isLostWithoutMasksAndGoesOnAfterwards) {
  show(see(0));
  Seen nobody = seeMasks(1);
  for (cv::Mat& mask : nobody.masks) mask.setTo(0);
  const BodyPose pose = show(nobody);
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "no start pose: no body is recognised");
  EXPECT_EQ(show(seeMasks(1)).status, PoseStatus::kTracked);
}

// An arm goes up faster than motion statistics allow for.
TEST_F(FleischmannTrackerTest, aLostArmIsFoundAgainByPartCurvesAfterAWhile) {
  FleischmannMotionStatistics slow = motion();
  slow.max_change.setConstant(0.002);
  tracker_ = trackerFor(rig_, slow);
  HsiaoVector raised = at(profile_, 0);
  show(see(raised));
  raised[hsiaoTheta(4)] -= degrees(90);
  const Seen seen = see(raised);
  int frames_lost = 0;
  BodyPose pose = show(seen);
  for (; pose.status == PoseStatus::kTracked && frames_lost < 30; ++frames_lost) {
    EXPECT_GT(error(pose, raised), 0.04);
    EXPECT_FALSE(pose.part_seen[size_t(PartLabel::kArm2)]);
    pose = show(seen);
  }
  EXPECT_NEAR(double(frames_lost * kFrame_ns), 0.4e9, 0.05e9);
  EXPECT_EQ(pose.status, PoseStatus::kReinitialized);
  EXPECT_LT(error(pose, raised), 0.04);
  for (int i = 0; i < 15; ++i) EXPECT_EQ(show(seen).status, PoseStatus::kTracked);
}

TEST_F(FleischmannTrackerTest, oneCameraIsNotEnough) {
  show(see(0));
  Seen seen = see(1);
  for (int i = 1; i < 4; ++i) seen.masks[size_t(i)] = cv::Mat();
  const BodyPose pose = show(seen);
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "no start pose: only one camera shows a person, at least two are needed");
}

TEST_F(FleischmannTrackerTest, startsAgainAfterAGapAndWhenTimeGoesBack) {
  show(see(0));
  stamp_ += 2000000000;
  EXPECT_EQ(show(seeMasks(1)).status, PoseStatus::kLost);
  BodyPose pose = show(see(1));
  ASSERT_EQ(pose.status, PoseStatus::kReinitialized) << pose.reason;
  EXPECT_LT(error(pose, 1), 0.04);
  pose = show(see(3), kFrame_ns);
  ASSERT_EQ(pose.status, PoseStatus::kReinitialized) << pose.reason;
  EXPECT_LT(error(pose, 3), 0.04);
}

TEST_F(FleischmannTrackerTest, limbsThatNothingSpeaksForAreNotSeen) {
  const BodyPose all = show(see(0));
  for (const bool seen : all.part_seen) EXPECT_TRUE(seen);
  // No mask shows the head any more.
  Eigen::Isometry3d root;
  Eigen::VectorXd angles;
  place(0, root, angles);
  LinkPoses links;
  body_->forwardKinematics(root, angles, links);
  const Eigen::Vector3d neck = links[size_t(body_->linkIndex("r_head"))].translation();
  Seen seen = seeMasks(0);
  for (size_t i = 0; i < 4; ++i) {
    const int row = int((*rig_[i].project(neck)).y());
    seen.masks[i].rowRange(0, row).setTo(0);
  }
  const BodyPose pose = show(seen);
  ASSERT_EQ(pose.status, PoseStatus::kTracked) << pose.reason;
  EXPECT_FALSE(pose.part_seen[size_t(PartLabel::kHead)]);
  EXPECT_TRUE(pose.part_seen[size_t(PartLabel::kLeg1)]);
  EXPECT_TRUE(pose.part_seen[size_t(PartLabel::kTorso)]);
}

TEST_F(FleischmannTrackerTest, dependsOnNoThreads) {
  const auto run = [&] {
    tracker_->reset();
    show(see(0), kFrame_ns);
    return show(seeMasks(1), 2 * kFrame_ns).angles;
  };
  const Eigen::VectorXd many = run();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(run(), many);
}

TEST_F(FleischmannTrackerTest, refusesWhatItCannotUse) {
  EXPECT_EQ(
      errorTextOf([&] { trackerFor(rig_, FleischmannMotionStatistics()); }),
      "pose_fitting/method is fleischmann, which needs motion statistics that are not all zero");
  TrackerOptions fleischmann;
  fleischmann.method = "fleischmann";
  EXPECT_EQ(errorTextOf([&] { makeBodyTracker({}, PersonResources::standard(), fleischmann); }),
            "pose_fitting/method is fleischmann, which needs a rig with cameras; without cameras, "
            "allowed is hsiao");
  Seen seen = see(0);
  seen.images.pop_back();
  EXPECT_EQ(errorTextOf([&] { show(seen); }), "3 images were given with 4 masks");
}

}  // namespace
}  // namespace markerless_mocap
