#pragma once

#include <vector>

#include "hull/voting/brick_volume.h"
#include "hull/voting/projection_table.h"

namespace markerless_mocap {

/// The rule of one vote over a lattice. A voxel is foreground if at least `min_views` cameras with
/// a mask see it, and the weights of those that have it outside their silhouette sum to less than
/// `limit`.
struct VoteRule {
  std::vector<const TileMask*> masks;  ///< one per camera; nullptr: the camera has no vote
  std::vector<uint32_t> weights;       ///< one per camera, up to kMaxWeight
  uint32_t limit = 1;                  ///< up to 32 * kMaxWeight
  int min_views = 2;
  VoxelBox window;  ///< voxels outside are background

  static constexpr uint32_t kMaxWeight = 16;
};

/// Sets `volume` to the foreground. The result equals that of a loop over all voxels and cameras.
/// An octree (Szeliski 1993) decides blocks by counts of tiles, and undecided bricks by their
/// pixels.
void vote(const ProjectionTable& table, const VoteRule& rule, BrickVolume* volume);

}  // namespace markerless_mocap
