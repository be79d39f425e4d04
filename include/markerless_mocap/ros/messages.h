#pragma once

// The generated messages live in the package's namespace, where the library has structs of the same
// names. Here the message types are called BodyPartsMsg, BodyPoseMsg and PoseTreeMsg. Code that
// uses both includes this header, never the generated ones.
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>
#include <markerless_mocap/BodyPart.h>
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
