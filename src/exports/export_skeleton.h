#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "exports/person_motion.h"

namespace markerless_mocap {

/// A joint of the skeleton that animation programs get: a ball joint for each link that turns as a
/// whole, and the links that are fixed to it where such programs expect a joint.
struct ExportJoint {
  std::string point;                               ///< name in pointNames()
  std::string name;                                ///< name in the file
  int parent = -1;                                 ///< index of an earlier joint; -1 for the root
  int link = 0;                                    ///< of the body
  Eigen::Vector3d rest = Eigen::Vector3d::Zero();  ///< place at rest
  Eigen::Matrix3d R_rest = Eigen::Matrix3d::Identity();  ///< rotation of the link at rest
  bool has_end = false;
  Eigen::Vector3d end = Eigen::Vector3d::Zero();  ///< place at rest of the tip, if it has one
};

/// At rest the person stands in the T-pose with the hips' centre in the origin: x to the front, y
/// to the left, z up, metres.
using ExportSkeleton = std::vector<ExportJoint>;

/// \param body with the links of this package's URDF; throws std::invalid_argument if one is
///   missing
/// \param names see pointNames(); joints that it does not name have MotionBuilder's names
ExportSkeleton exportSkeleton(const BodyModel& body, const std::string& names);

/// Rotations of all joints in one frame.
struct JointRotations {
  Eigen::Vector3d root;                      ///< place of the root in the world, metres
  std::vector<Eigen::Quaterniond> R_parent;  ///< from rest, in the parent's axes; of the root: in
                                             ///< the world's
  std::vector<bool> known;                   ///< false: the last known rotation, held
};

/// One per frame. Animations need a value in every frame: what is not known keeps its last known
/// value, and before that its first. Quaternions of following frames have no jumps of sign.
std::vector<JointRotations> jointRotations(const PersonMotion& motion,
                                           const ExportSkeleton& skeleton);

/// A stretch of frames in which a joint was not seen.
struct JointGap {
  std::string joint;
  size_t first = 0, last = 0;  ///< frames
  bool filled = false;         ///< by fillGaps(); false: held or empty
};
std::vector<JointGap> jointGaps(const PersonMotion& motion, const ExportSkeleton& skeleton);

}  // namespace markerless_mocap
