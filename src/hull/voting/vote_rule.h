#pragma once

#include <vector>

#include "hull/voting/brick_volume.h"
#include "hull/voting/projection_table.h"

namespace markerless_mocap {

/// One vote over a lattice. A voxel stands when at least `min_views` cameras with a mask see it and
/// the weights of those of them that have it outside their silhouette sum to less than `limit`.
struct VoteRule {
  std::vector<const TileMask*> masks;  ///< one per camera; nullptr: the camera has no vote
  std::vector<uint32_t> weights;       ///< one per camera, up to kMostWeight
  uint32_t limit = 1;                  ///< up to kMostLimit
  int min_views = 2;
  VoxelBox window;  ///< nothing stands outside

  static constexpr uint32_t kMostWeight = 16;
  static constexpr uint32_t kMostLimit = 32 * kMostWeight;
};

/// Replaces `volume` by the voxels that stand: exactly those of a loop over all voxels and cameras.
/// An octree (Szeliski 1993) decides blocks by counts of tiles, undecided leaves by their pixels.
void vote(const ProjectionTable& table, const VoteRule& rule, BrickVolume* volume);

}  // namespace markerless_mocap
