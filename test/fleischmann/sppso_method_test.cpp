#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "../appearance/appearance_scene.h"
#include "fleischmann/appearance_fitness.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "fleischmann/model/fleischmann_conversion.h"
#include "hsiao/model/hsiao_conversion.h"
#include "sentence_of.h"
#include "synthetic_person.h"

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

TrackerSources sources() {
  std::ifstream file(MOCAP_SOURCE_DIR "/urdf/human.urdf.in");
  std::stringstream text;
  text << file.rdbuf();
  TrackerSources sources;
  sources.urdf_template = text.str();
  sources.motion.largest_change.setConstant(0.05);
  sources.motion.largest_change.segment<3>(kPelvisPlace).setConstant(0.015);
  return sources;
}

TrackerOptions sppso() {
  TrackerOptions options;
  options.method = "sppso";
  options.skeleton.stature = 1.75;
  return options;
}

/// What the stages make of a person of cones.
struct Seen {
  std::vector<cv::Mat> masks, images;
  VisualHull hull;
  BodyParts parts;
  PoseTree tree;
};

class SppsoMethodTest : public testing::Test {
 protected:
  static HsiaoVector at(const HsiaoProfile& profile, int frame) {
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
    HsiaoConversion conversion(body_, std::make_shared<HsiaoProfile>(*body_));
    conversion.convert(v, root, angles);
  }

  Seen see(int frame) const { return see(at(profile_, frame)); }
  Seen see(const HsiaoVector& pose) const {
    Eigen::Isometry3d root;
    Eigen::VectorXd angles;
    place(pose, root, angles);
    const FleischmannVector v = FleischmannConversion(body_).parametersOf(root, angles);
    Seen seen;
    for (int i = 0; i < int(rig_.size()); ++i) {
      seen.masks.push_back(painter_.drawing(v.data(), i));
      seen.images.emplace_back(seen.masks.back().size(), CV_8UC1, cv::Scalar(160));
      seen.images.back().setTo(70, seen.masks.back());
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
    return tracker_->update({stamp_ns, seen.masks, seen.images, seen.hull, seen.parts, seen.tree});
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
  HsiaoProfile profile_{*body_};
  ProfileShape shape_{*body_, profile_};
  CameraRig rig_ = rigAroundThePerson();
  FleischmannProfile cones_profile_{*body_};
  AppearanceFitness painter_{rig_, cones_profile_, ConeBody(*body_, cones_profile_),
                             AppearanceOptions()};
  std::unique_ptr<BodyTracker> tracker_ = makeBodyTracker(rig_, sources(), sppso());
  int64_t stamp_ = 0;
};

TEST_F(SppsoMethodTest, startsFromPartsAndFollowsByMasksAlone) {
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
  EXPECT_FALSE(tracker_->body()->measured);
}

TEST_F(SppsoMethodTest, saysThatThereIsNoPoseToStartFrom) {
  const BodyPose pose = show(seeMasks(0));
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "no pose to start from: no body is recognised");
}

TEST_F(SppsoMethodTest, isLostWithoutMasksAndGoesOnAfterwards) {
  show(see(0));
  Seen nobody = seeMasks(1);
  for (cv::Mat& mask : nobody.masks) mask.setTo(0);
  const BodyPose pose = show(nobody);
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "no pose to start from: no body is recognised");
  EXPECT_EQ(show(seeMasks(1)).status, PoseStatus::kTracked);
}

// An arm goes up faster than motion statistics allow for.
TEST_F(SppsoMethodTest, aLostArmIsFoundAgainByPartCurvesAfterAWhile) {
  TrackerSources slow = sources();
  slow.motion.largest_change.setConstant(0.002);
  tracker_ = makeBodyTracker(rig_, slow, sppso());
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

TEST_F(SppsoMethodTest, oneCameraIsNotEnough) {
  show(see(0));
  Seen seen = see(1);
  for (int i = 1; i < 4; ++i) seen.masks[size_t(i)] = cv::Mat();
  const BodyPose pose = show(seen);
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "no pose to start from: one camera alone shows a person, needed are two");
}

TEST_F(SppsoMethodTest, startsAgainAfterAGapAndWhenTimeGoesBack) {
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

TEST_F(SppsoMethodTest, limbsThatNothingSpeaksForAreNotSeen) {
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

TEST_F(SppsoMethodTest, dependsOnNoThreads) {
  const auto run = [&] {
    tracker_->reset();
    show(see(0), kFrame_ns);
    return show(seeMasks(1), 2 * kFrame_ns).angles;
  };
  const Eigen::VectorXd many = run();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(run(), many);
}

TEST_F(SppsoMethodTest, refusesWhatItCannotUse) {
  TrackerSources still = sources();
  still.motion = MotionStatistics();
  EXPECT_EQ(sentenceOf([&] { makeBodyTracker(rig_, still, sppso()); }),
            "pose_fitting/method is sppso, which needs motion statistics in which something moves");
  EXPECT_EQ(sentenceOf([&] { makeBodyTracker({}, sources(), sppso()); }),
            "pose_fitting/method is sppso, which needs cameras; without any, allowed is skeleton");
  Seen seen = see(0);
  seen.images.pop_back();
  EXPECT_EQ(sentenceOf([&] { show(seen); }), "3 images came with 4 masks");
}

}  // namespace
}  // namespace markerless_mocap
