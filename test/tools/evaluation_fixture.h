#pragma once

#include <markerless_mocap/JointPositions.h>
#include <sensor_msgs/JointState.h>
#include <tf2_eigen/tf2_eigen.h>

#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "body/body_fixture.h"
#include "evaluation/body_points.h"
#include "evaluation/body_silhouette.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "tools/evaluate/evaluation.h"
#include "tools/offline/result_writer.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {

constexpr int64_t kBegin = 1600000000000000000, kStep = 40000000;  // 25 frames per second
constexpr int kFrames = 40;
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

  /// The left half of each mask: not the truth, so that nothing takes one for the other.
  static std::vector<cv::Mat> personsIn(std::vector<cv::Mat> masks) {
    for (cv::Mat& mask : masks) {
      mask = mask.clone();
      const cv::Rect box = cv::boundingRect(mask);
      mask(cv::Rect(box.x + box.width / 2, 0, mask.cols - box.x - box.width / 2, mask.rows)) = 0;
    }
    return masks;
  }

  /// Which fraction of a camera's masks is in those of personsIn(), mean over the frames.
  double shareOfPersons(size_t camera) const {
    double sum = 0;
    for (int f = 0; f < kFrames; ++f) {
      const std::vector<cv::Mat> masks = masksOf(poseOf(f));
      sum += double(cv::countNonZero(personsIn(masks)[camera])) / cv::countNonZero(masks[camera]);
    }
    return sum / kFrames;
  }

  /// A capture with ground truth.
  void writeTruth(const std::string& world = "world", bool masks = true) const {
    BagWriter bag(request_.truth);
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
      for (Eigen::Index i = 0; i < points.cols(); ++i)
        joints.positions.push_back(tf2::toMsg(Eigen::Vector3d(points.col(i))));
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
    geometry_msgs::TransformStamped out =
        tf2::eigenToTransform(camera.calibration().T_world_camera);
    out.header.frame_id = "world";
    out.child_frame_id = camera.name() + "_optical";
    return out;
  }

  void writeCameras(BagWriter* bag, std_msgs::Header header, const std::vector<cv::Mat>& masks,
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
    BagWriter bag(request_.results);
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
      writer.writeMasks(stampOf(f) + later_ns, cameras, result.masks, "silhouette");
      writer.writeMasks(stampOf(f) + later_ns, cameras, personsIn(result.masks), "person");
    }
    bag.commit();
  }

  /// The same without hulls and masks; the change may say anything else of a frame.
  void writeStages(const std::function<void(int frame, PipelineResult* result)>& change,
                   const std::string& world) const {
    writeTruth("world", false);
    BagWriter bag(request_.results);
    ResultWriter writer(&bag, model_, world);
    writer.writeDescription(kBegin, humanUrdf());
    for (int f = 0; f < kFrames; ++f) {
      PipelineResult result;
      result.pose = poseOf(f);
      change(f, &result);
      writer.write(stampOf(f), result);
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

}  // namespace markerless_mocap
