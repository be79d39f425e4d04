#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>

#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// kTracked: follows the last pose. kReinitialized: found from this frame alone. kLost: no pose.
enum class PoseStatus { kLost, kTracked, kReinitialized };
const char* toString(PoseStatus status);

/// Nothing but NaN.
template <size_t kCount>
constexpr std::array<double, kCount> allNaN() {
  std::array<double, kCount> values{};
  for (double& value : values) value = NAN;
  return values;
}

/// What `pose_fitting` says about one instant. Meaningful beyond status and reason only when the
/// status is not kLost.
struct BodyPose {
  PoseStatus status = PoseStatus::kLost;
  std::string reason;  ///< one sentence when lost, or when a part is not seen
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  Eigen::VectorXd angles;                    ///< radians, in the order of BodyModel::angleNames()
  std::array<bool, kPartCount> part_seen{};  ///< by PartLabel; the model's left limb is 1, right 2
  /// Expected error of each part's end (neck, head, wrists, ankles), metres, one standard
  /// deviation; NaN when the method does not tell.
  std::array<double, kPartCount> part_sigma_m = allNaN<kPartCount>();
  // Fitness; what the method does not go by is NaN.
  double silhouette_overlap = NAN;  ///< half the share of the body in the masks plus half the share
                                    ///< of the masks in the body, mean over the views, 0..1
  double skeleton_error_m = NAN;    ///< mean distance between part curves and model (Eq. 3-27)
  double hull_explained = NAN;      ///< share of hull voxels inside the body's shape, 0..1
  double body_in_hull = NAN;        ///< share of the body's volume inside the hull, 0..1
};

}  // namespace markerless_mocap
