#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>

#include "markerless_mocap/segmentation/body_parts.h"

namespace markerless_mocap {

/// kTracked: follows the last pose. kReinitialized: found from this frame alone. kLost: no pose.
enum class PoseStatus { kLost, kTracked, kReinitialized };
const char* toString(PoseStatus status);

/// What `pose_fitting` says about one instant. Meaningful beyond status and reason only when the
/// status is not kLost.
struct BodyPose {
  PoseStatus status = PoseStatus::kLost;
  std::string reason;  ///< one sentence when lost, or when a part is not seen
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  Eigen::VectorXd angles;                    ///< radians, in the order of BodyModel::angleNames()
  std::array<bool, kPartCount> part_seen{};  ///< by PartLabel; the model's left limb is 1, right 2
  double skeleton_error_m = 0.0;  ///< mean distance between part curves and model (Eq. 3-27)
  double hull_explained = 0.0;    ///< share of hull voxels inside the body's shape, 0..1
  double body_in_hull = 0.0;      ///< share of the body's volume inside the hull, 0..1
};

}  // namespace markerless_mocap
