#pragma once

// The generated messages are in the namespace of the package, where the core has structs of the
// same names. This header names the message types BodyPartsMsg, BodyPoseMsg and PoseTreeMsg.
// Include it instead of the generated headers.
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>
#include <markerless_mocap/BodyPart.h>
#include <markerless_mocap/HullCameras.h>
#include <markerless_mocap/MocapStatus.h>
#include <markerless_mocap/VoxelGrid.h>
#include <std_msgs/Header.h>

#define BodyParts BodyPartsMsg
#include <markerless_mocap/BodyParts.h>
#undef BodyParts
#define BodyPose BodyPoseMsg
#include <markerless_mocap/BodyPose.h>
#undef BodyPose
#define PoseTree PoseTreeMsg
#include <markerless_mocap/PoseTree.h>
#undef PoseTree
