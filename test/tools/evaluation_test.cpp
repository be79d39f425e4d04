#include "tools/evaluation.h"

#include <gtest/gtest.h>
#include <markerless_mocap/JointPositions.h>
#include <sensor_msgs/JointState.h>

#include <cmath>
#include <functional>

#include "body/body_fixture.h"
#include "markerless_mocap/evaluation/body_points.h"
#include "markerless_mocap/evaluation/body_silhouette.h"
#include "markerless_mocap/ros/camera_conversions.h"
#include "markerless_mocap/ros/image_conversions.h"
#include "tools/camera_bag.h"
#include "tools/evaluation_json.h"
#include "tools/evaluation_page.h"
#include "tools/evaluation_table.h"
#include "tools/result_writer.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kBegin = 1600000000000000000, kStep = 40000000;  // 25 frames per second
constexpr int kFrames = 40;
constexpr double kSameTransforms_mm = 1e-6;  // what remains of the way through quaternions

/// Somebody who walks across the stage of the ring of four and bends the left elbow; what a tracker
/// says is changed frame by frame.
class EvaluationTest : public ToolTest {
 protected:
  EvaluationTest() : model_(human()) {
    for (const CameraCalibration& camera : ringOfFour()) rig_.emplace_back(camera);
    request_.truth = path("truth.bag");
    request_.results = path("results.bag");
  }

  BodyPose poseAt(double seconds) const {
    BodyPose pose;
    pose.status = PoseStatus::kTracked;
    pose.T_world_body.translation() << 0.3 * std::sin(2 * seconds), 0.2 * std::cos(seconds), 0.9;
    pose.angles = Eigen::VectorXd::Zero(model_.angleCount());
    pose.angles[model_.angleIndex("l_elbow")] = 1.0 + 0.5 * std::sin(3 * seconds);
    pose.part_seen.fill(true);
    return pose;
  }
  static int64_t stampOf(int frame) { return kBegin + frame * kStep; }
  BodyPose poseOf(int frame) const { return poseAt(frame * kStep * 1e-9); }

  LinkPoses linksOf(const BodyPose& pose) const {
    LinkPoses T_world_link;
    model_.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
    return T_world_link;
  }

  std::vector<cv::Mat> masksOf(const BodyPose& pose) const {
    std::vector<cv::Mat> masks;
    for (const Camera& camera : rig_)
      masks.push_back(bodySilhouette(model_, linksOf(pose), camera));
    return masks;
  }

  /// A capture with ground truth.
  void writeTruth(const std::string& world = "world", bool masks = true) const {
    NewBag bag(request_.truth);
    tf2_msgs::TFMessage statics;
    for (const Camera& camera : rig_) statics.transforms.push_back(cameraTransform(camera));
    bag.writeLatched("/tf_static", rosTime(kBegin), statics);
    for (int f = 0; f < kFrames; ++f) {
      const BodyPose pose = poseOf(f);
      JointPositions joints;
      joints.header.stamp = rosTime(stampOf(f));
      joints.header.frame_id = world;
      joints.names = bodyPointNames();
      const Eigen::Matrix3Xd points = bodyPoints(model_, linksOf(pose));
      for (Eigen::Index i = 0; i < points.cols(); ++i) {
        joints.positions.emplace_back();
        joints.positions.back().x = points(0, i);
        joints.positions.back().y = points(1, i);
        joints.positions.back().z = points(2, i);
      }
      bag.write("/ground_truth/joints", joints.header.stamp, joints);
      sensor_msgs::JointState angles;
      angles.header = joints.header;
      angles.name = model_.angleNames();
      angles.position.assign(pose.angles.data(), pose.angles.data() + pose.angles.size());
      bag.write("/ground_truth/joint_states", joints.header.stamp, angles);
      writeCameras(&bag, joints.header, masksOf(pose), masks);
    }
    bag.commit();
  }

  static geometry_msgs::TransformStamped cameraTransform(const Camera& camera) {
    const Eigen::Isometry3d& T = camera.calibration().T_world_camera;
    const Eigen::Quaterniond q(T.linear());
    geometry_msgs::TransformStamped out;
    out.header.frame_id = "world";
    out.child_frame_id = camera.name() + "_optical";
    out.transform.translation.x = T.translation().x();
    out.transform.translation.y = T.translation().y();
    out.transform.translation.z = T.translation().z();
    out.transform.rotation.x = q.x();
    out.transform.rotation.y = q.y();
    out.transform.rotation.z = q.z();
    out.transform.rotation.w = q.w();
    return out;
  }

  void writeCameras(NewBag* bag, std_msgs::Header header, const std::vector<cv::Mat>& masks,
                    bool with_masks) const {
    for (size_t c = 0; c < rig_.size(); ++c) {
      header.frame_id = rig_[c].name() + "_optical";
      sensor_msgs::CameraInfo info = messageFromCalibration(rig_[c].calibration());
      info.header = header;
      bag->write("/" + rig_[c].name() + "/camera_info", header.stamp, info);
      bag->write("/" + rig_[c].name() + "/image_raw", header.stamp,
                 messageFromMat(smallImage(true), header));
      if (with_masks)
        bag->write("/ground_truth/" + rig_[c].name() + "/silhouette", header.stamp,
                   messageFromMat(masks[c], header));
    }
  }

  using Change = std::function<void(int frame, BodyPose* pose)>;

  /// What a tracker writes that knows the truth but for the change; a hull and masks come with it.
  void writeResults(const Change& change, const std::string& world = "world",
                    int64_t later_ns = 0) const {
    HullOptions hull_options;
    hull_options.pitch = 0.1;
    HullCarver carver(rig_, hull_options);
    NewBag bag(request_.results);
    ResultWriter writer(&bag, model_, world);
    writer.writeDescription(kBegin, humanUrdf());
    std::vector<RecordedCamera> cameras;
    for (const Camera& camera : rig_)
      cameras.push_back({camera.name(), "", "", "", camera.name() + "_optical"});
    for (int f = 0; f < kFrames; ++f) {
      PipelineResult result;
      result.pose = poseOf(f);
      result.masks = masksOf(result.pose);
      std::vector<HullView> views;
      for (const cv::Mat& mask : result.masks) views.push_back({mask, cv::Mat()});
      result.hull = carver.carve(views);
      change(f, &result.pose);
      writer.write(stampOf(f) + later_ns, result);
      writer.writeMasks(stampOf(f) + later_ns, cameras, result.masks);
    }
    bag.commit();
  }

  Evaluation judged() const {
    return evaluate(request_, [](double) {});
  }
  static void nothing(int, BodyPose*) {}

  BodyModel model_;
  CameraRig rig_;
  EvaluationRequest request_;
};

TEST_F(EvaluationTest, TruthAgainstItselfIsPerfectThroughBothBags) {
  writeTruth();
  writeResults(nothing);
  const Evaluation found = judged();
  EXPECT_EQ(found.body_id, "person1");
  EXPECT_EQ(found.joints.frames_estimated, size_t(kFrames));
  EXPECT_LT(found.joints.D_spread.max, kSameTransforms_mm);
  EXPECT_EQ(found.joints.swaps.all, 0.0);
  EXPECT_EQ(found.record.tracked, size_t(kFrames));
  EXPECT_NEAR(found.delay.seconds, 0.0, 1e-3);
  for (const ExtremityError& part : found.extremities) {
    EXPECT_LT(part.error_mm.max, kSameTransforms_mm) << part.name;
    EXPECT_EQ(part.share_right, 1.0) << part.name;
  }
  ASSERT_EQ(found.angles.size(), size_t(model_.angleCount()));
  for (const AngleError& angle : found.angles) EXPECT_EQ(angle.error_deg.max, 0.0) << angle.joint;
  EXPECT_EQ(found.latency_ms.count, 0u);
  EXPECT_TRUE(found.notes.empty());
}

TEST_F(EvaluationTest, SilhouettesBodyAndHullOfTheTruthOverlapWholly) {
  writeTruth();
  writeResults(nothing);
  const ImageMeasures images = judged().images;
  EXPECT_EQ(images.instants.size(), size_t(kFrames));
  ASSERT_EQ(images.cameras.size(), 4u);
  for (size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(images.mask_iou[c].mean, 1.0) << c;
    EXPECT_EQ(images.body_iou[c].mean, 1.0) << c;
  }
  EXPECT_EQ(images.hull_iou.count, size_t(kFrames));
  EXPECT_EQ(images.hull_iou.mean, 1.0);
}

TEST_F(EvaluationTest, AShiftComesBackAndCostsOverlapOfTheBodyOnly) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->T_world_body.translation().z() += 0.1; });
  const Evaluation found = judged();
  EXPECT_NEAR(found.joints.D_spread.mean, 100.0, kSameTransforms_mm);
  EXPECT_NEAR(found.joints.D_mean_unbiased, 0.0, kSameTransforms_mm);
  EXPECT_LT(meanOfMeans(found.images.body_iou), 0.9);
  EXPECT_EQ(meanOfMeans(found.images.mask_iou), 1.0);
}

TEST_F(EvaluationTest, LostFramesHaveNoEstimateEvenIfTfStandsStill) {
  writeTruth();
  writeResults([](int f, BodyPose* pose) {
    if (f >= 10 && f < 15) pose->status = PoseStatus::kLost, pose->reason = "nobody is there";
    if (f == 15) pose->status = PoseStatus::kReinitialized;
  });
  {
    rosbag::Bag bag(request_.results, rosbag::bagmode::Append);  // somebody repeats the last frame
    tf2_msgs::TFMessage still;
    still.transforms.push_back(cameraTransform(rig_[0]));
    still.transforms[0].header.stamp = rosTime(stampOf(12));
    still.transforms[0].child_frame_id = "body_person1";
    bag.write("/tf", rosTime(stampOf(12)), still);
  }
  const Evaluation found = judged();
  EXPECT_EQ(found.joints.frames_estimated, size_t(kFrames - 5));
  EXPECT_EQ(found.record.lost, 5u);
  EXPECT_EQ(found.record.reinitialized, 1u);
  ASSERT_EQ(found.record.losses.size(), 1u);
  EXPECT_NEAR(found.record.losses[0].seconds, 0.2, 1e-9);
  EXPECT_EQ(found.reasons[12], "nobody is there");
  EXPECT_LT(found.joints.D_spread.max, kSameTransforms_mm);
}

TEST_F(EvaluationTest, PartsThatAreNotSeenAreMissingMarkers) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->part_seen[size_t(PartLabel::kArm1)] = false; });
  const Evaluation found = judged();
  EXPECT_NEAR(found.joints.share_markers_missing, 3.0 / 15, 1e-12);
  EXPECT_NEAR(found.extremities[0].share_right, 0.5, 1e-12);
}

TEST_F(EvaluationTest, DelayComesBack) {
  writeTruth();
  writeResults([this](int f, BodyPose* pose) { *pose = poseAt(f * kStep * 1e-9 - 0.06); });
  EXPECT_NEAR(judged().delay.seconds, 0.06, 0.002);
}

TEST_F(EvaluationTest, AnglesAreComparedByName) {
  writeTruth();
  writeResults(
      [this](int, BodyPose* pose) { pose->angles[model_.angleIndex("r_knee")] = M_PI / 6; });
  for (const AngleError& angle : judged().angles)
    EXPECT_NEAR(angle.error_deg.mean, angle.joint == "r_knee" ? 30.0 : 0.0, 1e-9) << angle.joint;
}

TEST_F(EvaluationTest, SkippedSecondsAreLeftOut) {
  writeTruth();
  writeResults([](int f, BodyPose* pose) {
    if (f < 10) pose->T_world_body.translation().x() += 1.0;
  });
  request_.skip = 0.4;  // ten frames
  const Evaluation found = judged();
  EXPECT_EQ(found.joints.frames, size_t(kFrames - 10));
  EXPECT_LT(found.joints.D_spread.max, kSameTransforms_mm);
  request_.skip = 60;
  EXPECT_EQ(refusalOf([&] { judged(); }),
            "nothing is left to judge: the truth lasts less than the time to skip");
}

TEST_F(EvaluationTest, AResultThatIsLostThroughoutIsAResult) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->status = PoseStatus::kLost; });
  const Evaluation found = judged();
  EXPECT_EQ(found.joints.share_without_estimate, 1.0);
  EXPECT_TRUE(std::isnan(found.joints.D_spread.mean));
  EXPECT_NE(evaluationJson(found).find("\"D_mean\": null"), std::string::npos);
  EXPECT_NE(evaluationPage(found).find("40 lost"), std::string::npos);
}

TEST_F(EvaluationTest, JsonAndPageCarryTheFigures) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->T_world_body.translation().z() += 0.1; });
  request_.pictures = true;
  const Evaluation found = judged();
  ASSERT_EQ(found.pictures.size(), 3u);
  EXPECT_EQ(found.pictures[0].caption.rfind("worst: D = 100 mm", 0), 0u);
  const std::string page = evaluationPage(found);
  EXPECT_NE(page.find("<b>100.0 mm</b>"), std::string::npos);
  EXPECT_NE(page.find("data:image/jpeg;base64,/9j/"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);  // needs nothing beside it
  EXPECT_NE(evaluationJson(found).find("\"swap_rate\": 0"), std::string::npos);
  std::ostringstream table;
  printEvaluation(found, table);
  EXPECT_NE(table.str().find("mean            100.0   (0.0 with"), std::string::npos)
      << table.str();
}

TEST_F(EvaluationTest, WithoutExactMasksJointsAreJudgedAndANoteSaysSo) {
  writeTruth("world", false);
  writeResults(nothing);
  const Evaluation found = judged();
  EXPECT_LT(found.joints.D_spread.max, kSameTransforms_mm);
  EXPECT_EQ(found.notes, std::vector<std::string>{"Silhouettes and hull are not judged: the truth "
                                                  "has no exact masks."});
}

TEST_F(EvaluationTest, FaultsAreOneSentenceEach) {
  EXPECT_EQ(refusalOf([&] { judged(); }), "there is no bag " + request_.truth);
  writeResults(nothing);
  request_.truth = request_.results;
  EXPECT_EQ(refusalOf([&] { judged(); }),
            request_.results + " has no ground truth: no topic /ground_truth/joints");
  request_.truth = path("truth.bag");
  writeTruth();
  request_.results = request_.truth;
  EXPECT_EQ(refusalOf([&] { judged(); }),
            request_.truth + " has no results: neither a frame body_<id> in tf nor /pose");
  request_.results = path("results.bag");
  request_.body_id = "person2";
  EXPECT_EQ(refusalOf([&] { judged(); }),
            request_.results + " has no body person2, it has person1");
}

TEST_F(EvaluationTest, OtherWorldsAndOtherTimesAreRefused) {
  writeTruth();
  writeResults(nothing, "map");
  EXPECT_EQ(refusalOf([&] { judged(); }),
            "the results are in the frame map, the truth in world: they cannot be compared");
  writeResults(nothing, "world", 3600 * int64_t(1000000000));
  EXPECT_EQ(refusalOf([&] { judged(); })
                .rfind("truth and results do not overlap in time: the "
                       "truth lasts from 1600000000.00 s to "
                       "1600000001.56 s, the results from 16000036",
                       0),
            0u);
}

}  // namespace
}  // namespace markerless_mocap
