#pragma once

#include <vector>

#include "hull/selection/components.h"
#include "hull/voting/vote_rule.h"
#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// Holds the masks of one frame set, and carves components with any subset of the cameras.
class VoxelVoting {
 public:
  /// Throws std::invalid_argument as HullCarver(). The rig must outlive this object.
  VoxelVoting(const CameraRig& rig, const HullOptions& options, const VoxelLattice& lattice);

  void setMasks(const std::vector<HullView>& views);

  /// Components of the foreground by the votes of `voters`: largest first, suspected ghosts last,
  /// components of one body joined. Cameras without a mask or without trust never vote.
  std::vector<VoxelComponent> carve(CameraSet voters, const VoxelBox& window);
  /// The box outside of which all voxels are background.
  const VoxelBox& bounds() const { return bounds_; }

  const ProjectionTable& table() const { return table_; }
  const TileMask& mask(size_t camera) const { return masks_[camera]; }
  CameraSet present() const { return present_; }

 private:
  const BrickVolume& vote(CameraSet voters, int more_missing, const VoxelBox& window);
  bool isSeenEnough() const;

  const CameraRig& rig_;
  HullOptions options_;
  ProjectionTable table_;
  std::vector<uint32_t> weights_;  ///< trust of each camera, in integer units
  uint32_t unit_;                  ///< weight of full trust
  VoxelBox bounds_;
  std::vector<TileMask> masks_;
  CameraSet present_ = 0;
  BrickVolume volume_;
  ComponentFinder components_;
};

}  // namespace markerless_mocap
