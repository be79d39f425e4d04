#include "ros/pose_conversions.h"

#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <stdexcept>

#include "tracking/part_of_joint.h"

namespace markerless_mocap {
namespace {

bool isSeen(const BodyModel& model, const BodyPose& pose, const BodyJoint& joint) {
  return pose.part_seen[static_cast<size_t>(partOfLink(model, joint.child_link))];
}

/// Per link: true if its part or that of a descendant is seen.
std::vector<bool> neededLinks(const BodyModel& model, const BodyPose& pose) {
  std::vector<bool> needed(model.links().size(), false);
  for (auto joint = model.joints().rbegin(); joint != model.joints().rend(); ++joint) {
    const size_t child = size_t(joint->child_link);
    needed[child] = needed[child] || isSeen(model, pose, *joint);
    if (needed[child]) needed[size_t(joint->parent_link)] = true;
  }
  return needed;
}

uint8_t statusToMessage(PoseStatus status) {
  switch (status) {
    case PoseStatus::kLost:
      return BodyPoseMsg::LOST;
    case PoseStatus::kTracked:
      return BodyPoseMsg::TRACKED;
    case PoseStatus::kReinitialized:
      return BodyPoseMsg::REINITIALIZED;
  }
  throw std::invalid_argument("unknown pose status");
}

void checkUsable(const BodyModel& model, const BodyPose& pose) {
  const bool usable = pose.status != PoseStatus::kLost && pose.T_world_body.matrix().allFinite() &&
                      pose.angles.size() == model.angleCount() && pose.angles.allFinite();
  if (!usable) throw std::invalid_argument("the pose of " + model.id() + " is lost or not finite");
}

geometry_msgs::TransformStamped stamped(const Eigen::Isometry3d& T_parent_child,
                                        const std_msgs::Header& header, const std::string& parent,
                                        const std::string& child) {
  geometry_msgs::TransformStamped transform = tf2::eigenToTransform(T_parent_child);
  transform.header.stamp = header.stamp;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  return transform;
}

}  // namespace

const char* sidedPartName(PartLabel label) {
  constexpr const char* kNames[kPartCount] = {"torso", "head", "l_arm", "r_arm", "l_leg", "r_leg"};
  return kNames[static_cast<size_t>(label)];
}

sensor_msgs::JointState jointStateFromPose(const BodyModel& model, const BodyPose& pose,
                                           const std_msgs::Header& header) {
  sensor_msgs::JointState state;
  state.header = header;
  if (pose.status == PoseStatus::kLost) return state;
  checkUsable(model, pose);
  for (const BodyJoint& joint : model.joints()) {
    if (joint.angle_index < 0 || !isSeen(model, pose, joint)) continue;
    state.name.push_back(joint.name);
    state.position.push_back(pose.angles[joint.angle_index]);
  }
  return state;
}

BodyPoseMsg messageFromPose(const BodyModel& model, const BodyPose& pose,
                            const std_msgs::Header& header) {
  BodyPoseMsg message;
  message.header = header;
  message.body_id = model.id();
  message.status = statusToMessage(pose.status);
  message.reason = pose.reason;
  std::copy(pose.part_sigma_m.begin(), pose.part_sigma_m.end(), message.part_deviation.begin());
  message.silhouette_overlap = pose.silhouette_overlap;
  message.skeleton_error = pose.skeleton_error_m;
  message.hull_explained = pose.hull_explained;
  message.body_in_hull = pose.body_in_hull;
  message.pose.orientation.w = 1.0;
  if (pose.status == PoseStatus::kLost) return message;
  const sensor_msgs::JointState joints = jointStateFromPose(model, pose, header);
  message.pose = tf2::toMsg(pose.T_world_body);
  message.joint_names = joints.name;
  message.joint_angles = joints.position;
  for (int label = 0; label < kPartCount; ++label)
    if (!pose.part_seen[label])
      message.parts_not_seen.emplace_back(sidedPartName(static_cast<PartLabel>(label)));
  return message;
}

geometry_msgs::TransformStamped rootTransform(const BodyModel& model, const BodyPose& pose,
                                              const std_msgs::Header& header) {
  checkUsable(model, pose);
  return stamped(pose.T_world_body, header, header.frame_id, model.links().front());
}

std::vector<geometry_msgs::TransformStamped> linkTransforms(const BodyModel& model,
                                                            const BodyPose& pose,
                                                            const std_msgs::Header& header) {
  std::vector<geometry_msgs::TransformStamped> transforms{rootTransform(model, pose, header)};
  LinkPoses T_world_link;
  model.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
  const std::vector<bool> needed = neededLinks(model, pose);
  for (const BodyJoint& joint : model.joints()) {
    if (!needed[size_t(joint.child_link)]) continue;
    const Eigen::Isometry3d T_parent_child =
        T_world_link[joint.parent_link].inverse() * T_world_link[joint.child_link];
    transforms.push_back(stamped(T_parent_child, header, model.links()[joint.parent_link],
                                 model.links()[joint.child_link]));
  }
  return transforms;
}

}  // namespace markerless_mocap
