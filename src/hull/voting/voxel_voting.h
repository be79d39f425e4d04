#pragma once

#include <vector>

#include "hull/selection/components.h"
#include "hull/voting/vote_rule.h"
#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// Holds the masks of one instant and carves pieces with any of the cameras.
class VoxelVoting {
 public:
  /// Throws std::invalid_argument as HullCarver(). The rig must live as long.
  VoxelVoting(const CameraRig& rig, const HullOptions& options, const VoxelLattice& lattice);

  void setMasks(const std::vector<HullView>& views);

  /// Components of the foreground by the votes of `voters`, largest first, suspect ghosts last,
  /// pieces of one body joined. Cameras without a mask or trust have no vote in any case.
  std::vector<VoxelComponent> carve(CameraSet voters, const VoxelBox& window);
  /// The box in which anything may stand.
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
  std::vector<uint32_t> weights_;  ///< trust of each camera in units
  uint32_t unit_;                  ///< weight of full trust
  VoxelBox bounds_;
  std::vector<TileMask> masks_;
  CameraSet present_ = 0;
  BrickVolume volume_;
  ComponentFinder components_;
};

}  // namespace markerless_mocap
