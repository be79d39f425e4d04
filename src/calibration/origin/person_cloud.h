#pragma once

#include <optional>
#include <vector>

#include "calibration/walk_floor.h"

namespace markerless_mocap {

/// A box of voxels.
struct VoxelBox {
  Eigen::Isometry3d world_box = Eigen::Isometry3d::Identity();  ///< its middle and axes
  Eigen::Vector3d half = Eigen::Vector3d::Zero();               ///< half its sides, m
  double voxel = 0.04;                                          ///< m
};

/// Middles of the voxels that no silhouette excludes and at least two contain.
/// \return 3 x N, m, in the frame of the box
Eigen::Matrix3Xd hullIn(const VoxelBox& box, const CameraRig& cameras,
                        const SilhouetteSet& silhouettes);

/// A person at one time.
struct PersonCloud {
  Eigen::Matrix3Xd points;                           ///< m, world
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< m, world
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< the longest one; its sign means nothing
  double slenderness = 0.0;                          ///< length by the larger of the widths
};

/// The person's hull where the silhouettes' middles meet; empty if fewer than two silhouettes show
/// a person or they do not meet.
std::optional<PersonCloud> personIn(const CameraRig& cameras, const SilhouetteSet& silhouettes);

}  // namespace markerless_mocap
