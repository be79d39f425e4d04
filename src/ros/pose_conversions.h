#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/JointState.h>

#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

/// Part of the body that a joint moves, from its name without the id ("l_y_shoulder"). The left
/// limb is number 1. What is no limb and no head is the torso.
PartLabel partOfJoint(const std::string& base_name);

/// Names a user reads: torso, head, l_arm, r_arm, l_leg, r_leg.
const char* sidedPartName(PartLabel label);

/// Status, pose, angles and fitness. Joints of parts that are not seen are left out and the parts
/// named; a lost pose carries no joints.
BodyPoseMsg messageFromPose(const BodyModel& model, const BodyPose& pose,
                            const std_msgs::Header& header);

/// Names and angles (rad) of the joints of seen parts; none when lost.
sensor_msgs::JointState jointStateFromPose(const BodyModel& model, const BodyPose& pose,
                                           const std_msgs::Header& header);

/// header.frame_id -> body_<id>. Throws std::invalid_argument when the pose is lost or not finite:
/// there is no transform then.
geometry_msgs::TransformStamped rootTransform(const BodyModel& model, const BodyPose& pose,
                                              const std_msgs::Header& header);

/// Parent -> child for every link of seen parts and those they hang on, root first, so that frames
/// connect. Throws as `rootTransform`.
std::vector<geometry_msgs::TransformStamped> linkTransforms(const BodyModel& model,
                                                            const BodyPose& pose,
                                                            const std_msgs::Header& header);

}  // namespace markerless_mocap
