#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>

#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// kTracked: tracked from the last pose. kReinitialized: the first pose after a start, or an
/// alternative hypothesis that has replaced the last pose. kLost: no pose.
enum class PoseStatus { kLost, kTracked, kReinitialized };
const char* toString(PoseStatus status);

/// An array of NaN.
template <size_t kCount>
constexpr std::array<double, kCount> allNaN() {
  std::array<double, kCount> values{};
  for (double& value : values) value = NAN;
  return values;
}

/// Result of `pose_fitting` for one frame set. If the status is kLost, only `status`, `reason`
/// and the measures of the quality of the fit are valid.
struct BodyPose {
  PoseStatus status = PoseStatus::kLost;
  /// message for the user if lost, a part is not seen or a camera is left out, else empty
  std::string reason;
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  Eigen::VectorXd angles;  ///< radians, in the order of BodyModel::angleNames()
  /// By PartLabel; limb 1 is the model's left, limb 2 its right.
  std::array<bool, kPartCount> part_seen{};
  /// Standard deviation of the position of each part's end (neck, head, wrists, ankles), metres, by
  /// PartLabel; NaN if the method does not estimate it.
  std::array<double, kPartCount> part_sigma_m = allNaN<kPartCount>();
  // Quality of the fit. Measures that the method does not use are NaN.
  /// Mean of two fractions, that of the body inside the masks and that of the masks inside the
  /// body; mean over the views, 0 to 1.
  double silhouette_overlap = NAN;
  double skeleton_error_m = NAN;  ///< mean distance between part curves and model (Eq. 3-27)
  double hull_explained = NAN;    ///< fraction of hull voxels inside the body's shape, 0 to 1
  double body_in_hull = NAN;      ///< fraction of the body's volume inside the hull, 0 to 1
};

}  // namespace markerless_mocap
