// The person is followed back through frame sets without a pose.
#include "markerless_mocap/pipeline/pipeline.h"
#include "pipeline/contour_method.h"
#include "pipeline/lost_frame_sets.h"

namespace markerless_mocap {
namespace {

constexpr double kError_m = 0.02;  // mean over the joints

/// Some frames of the walk, which the tracker has not seen.
class FollowBackTest : public ContourMethodTest {
 protected:
  int64_t stampOf(int frame) const { return int64_t(frame + 1) * kFrame_ns; }
  FrameSet frameSet(int frame) const {
    FrameSet set{stampOf(frame), std::vector<CameraFrame>(rig.size()), {}};
    for (size_t i = 0; i < rig.size(); ++i) set.frames[i].mask = masksAt(frame)[i];
    return set;
  }
  void lose(int frame) { lost.add(frameSet(frame), masksAt(frame), {}); }
  void loseNobody(int frame) {
    const cv::Mat nobody = cv::Mat::zeros(240, 320, CV_8UC1);
    lost.add(frameSet(frame), std::vector<cv::Mat>(rig.size(), nobody), {});
  }
  /// Shows two frames, so that it is known how the person moves.
  void showFrom(int frame) {
    stamp_ns = stampOf(frame - 1);
    ASSERT_NE(show(frame).status, PoseStatus::kLost);
    ASSERT_NE(show(frame + 1).status, PoseStatus::kLost);
  }

  LostFrameSets lost;
};

TEST_F(FollowBackTest, PosesOfEarlierFramesAreRightAndInOrder) {
  makeMeasured();
  for (int frame = 0; frame < 20; ++frame) lose(frame);
  stamp_ns = stampOf(19);
  ASSERT_EQ(show(20).status, PoseStatus::kReinitialized);
  const std::vector<EarlierPose> poses = lost.followedBackBy(*tracker);
  ASSERT_EQ(poses.size(), 20u);
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_EQ(poses[frame].stamp_ns, stampOf(frame));
    EXPECT_EQ(poses[frame].pose.status, PoseStatus::kTracked);
    EXPECT_LT(error(poses[frame].pose, frame), kError_m) << frame;
  }
  EXPECT_TRUE(lost.followedBackBy(*tracker).empty()) << "they have been found";
}

TEST_F(FollowBackTest, LaterPosesAreAsIfNothingHadBeen) {
  makeMeasured();
  showFrom(10);
  std::vector<BodyPose> expected;
  for (int frame = 12; frame < 20; ++frame) expected.push_back(show(frame));
  makeMeasured();
  for (int frame = 0; frame < 10; ++frame) lose(frame);
  showFrom(10);
  EXPECT_EQ(lost.followedBackBy(*tracker).size(), 10u);
  for (int frame = 12; frame < 20; ++frame) {
    const BodyPose pose = show(frame);
    EXPECT_EQ(pose.status, expected[size_t(frame - 12)].status);
    EXPECT_EQ(pose.angles, expected[size_t(frame - 12)].angles) << frame;
    EXPECT_EQ(pose.silhouette_overlap, expected[size_t(frame - 12)].silhouette_overlap);
  }
}

TEST_F(FollowBackTest, EndsWhereThePersonIsNotSeen) {
  makeMeasured();
  for (int frame = 0; frame < 5; ++frame) lose(frame);
  loseNobody(5);
  for (int frame = 6; frame < 10; ++frame) lose(frame);
  stamp_ns = stampOf(9);
  show(10);
  const std::vector<EarlierPose> poses = lost.followedBackBy(*tracker);
  ASSERT_EQ(poses.size(), 4u);
  EXPECT_EQ(poses.front().stamp_ns, stampOf(6));
  EXPECT_EQ(show(11).status, PoseStatus::kTracked) << "the newest pose is not lost";
}

TEST_F(FollowBackTest, OnlyTheLastFrameSetsAreKept) {
  makeMeasured();
  const int most = Pipeline::kMostEarlierPoses;
  for (int frame = 0; frame < most + 3; ++frame) lose(frame);
  stamp_ns = stampOf(most + 2);
  show(most + 3);
  const std::vector<EarlierPose> poses = lost.followedBackBy(*tracker);
  ASSERT_EQ(poses.size(), size_t(most));
  EXPECT_EQ(poses.front().stamp_ns, stampOf(3));
}

TEST_F(FollowBackTest, NothingIsFoundFromNoPoseOrFromABodyThatIsBeingMeasured) {
  makeMeasured();
  lose(0);
  stamp_ns = stampOf(0);
  showNothing();
  EXPECT_TRUE(lost.followedBackBy(*tracker).empty());
  resources.known_shape.reset();
  make();
  lose(0);
  stamp_ns = stampOf(0);
  show(1);
  EXPECT_EQ(show(2).status, PoseStatus::kReinitialized);
  EXPECT_TRUE(lost.followedBackBy(*tracker).empty());
}

/// Five frame sets in which two cameras see the person, too few to find anybody, then all do.
class FollowBackStream : public FollowBackTest {
 protected:
  static constexpr int kFewCameras = 5, kFrames = 12;

  FollowBackStream() {
    resources.known_shape = truth();
    stages.fitting = options;
    stages.hull.min_views = 3;
  }
  FrameSet frameSetOfStream(int frame) const {
    FrameSet set = frameSet(frame);
    for (size_t i = 2; frame < kFewCameras && i < rig.size(); ++i) set.frames[i].mask = cv::Mat();
    return set;
  }
  std::vector<BodyPose> run(bool follow_back, int frames = kFrames) const {
    Pipeline pipeline(rig, resources, stages);
    if (follow_back) pipeline.followBack();
    std::vector<BodyPose> poses;
    int next = 0;
    pipeline.processStream(
        [&]() -> std::optional<FrameSet> {
          if (next == frames) return std::nullopt;
          return frameSetOfStream(next++);
        },
        [&](const FrameSet& frame_set, const PipelineResult& result) {
          EXPECT_EQ(frame_set.stamp_ns, stampOf(int(poses.size()))) << "the order of time";
          poses.push_back(result.pose);
        });
    return poses;
  }

  PipelineOptions stages;
};

TEST_F(FollowBackStream, BeginsWithThePerson) {
  const std::vector<BodyPose> forward = run(false), poses = run(true);
  ASSERT_EQ(forward.size(), size_t(kFrames));
  ASSERT_EQ(poses.size(), size_t(kFrames));
  tracker = makeBodyTracker(rig, resources, options);  // its body is that of the poses
  for (int frame = 0; frame < kFrames; ++frame) {
    const BodyPose& pose = poses[size_t(frame)];
    EXPECT_EQ(pose.status, frame ? PoseStatus::kTracked : PoseStatus::kReinitialized) << frame;
    EXPECT_LT(error(pose, frame), 2 * kError_m) << frame;
    if (frame < kFewCameras)
      EXPECT_EQ(forward[size_t(frame)].status, PoseStatus::kLost) << frame;
    else
      EXPECT_EQ(pose.angles, forward[size_t(frame)].angles) << frame;
  }
}

TEST_F(FollowBackStream, WhoIsNeverFoundIsLostInEveryFrameSet) {
  const std::vector<BodyPose> poses = run(true, kFewCameras);
  ASSERT_EQ(poses.size(), size_t(kFewCameras)) << "also those that are held to the end";
  for (const BodyPose& pose : poses) EXPECT_EQ(pose.status, PoseStatus::kLost);
}

}  // namespace
}  // namespace markerless_mocap
