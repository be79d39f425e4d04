#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/JointState.h>

#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

/// Names for users: torso, head, l_arm, r_arm, l_leg, r_leg.
const char* sidedPartName(PartLabel label);

/// Status, pose, angles and quality. Joints of parts that are not seen are left out, and these
/// parts are listed. A lost pose has no joints.
BodyPoseMsg messageFromPose(const BodyModel& model, const BodyPose& pose,
                            const std_msgs::Header& header);

/// Names and angles (rad) of the joints of seen parts; none if the pose is lost.
sensor_msgs::JointState jointStateFromPose(const BodyModel& model, const BodyPose& pose,
                                           const std_msgs::Header& header);

/// header.frame_id -> body_<id>. Throws std::invalid_argument if the pose is lost or not finite.
geometry_msgs::TransformStamped rootTransform(const BodyModel& model, const BodyPose& pose,
                                              const std_msgs::Header& header);

/// Parent -> child for every link of a seen part and for its ancestors, root first, so that all
/// frames are connected. Throws as `rootTransform`.
std::vector<geometry_msgs::TransformStamped> linkTransforms(const BodyModel& model,
                                                            const BodyPose& pose,
                                                            const std_msgs::Header& header);

}  // namespace markerless_mocap
