#pragma once

#include <functional>
#include <vector>

#include "hull/selection/voxel_component.h"

namespace markerless_mocap {

/// Joins pieces of one body that a lost vote has cut apart. Each further piece of at least
/// `min_voxels` that is no suspect ghost is joined to the largest one by the voxels on the
/// shortest ways between the two through `loose` and all pieces, if any are shorter than 0.5 m.
class ComponentBridging {
 public:
  /// What stands in a box when more votes may be missing.
  using RelaxedVote = std::function<const BrickVolume&(const VoxelBox&)>;

  ComponentBridging(const VoxelLattice& lattice, RelaxedVote relaxed_vote)
      : lattice_(lattice), relaxed_vote_(std::move(relaxed_vote)) {}

  /// \param pieces largest first \return in the same order, what was joined in the first one
  std::vector<VoxelComponent> bridge(std::vector<VoxelComponent> components,
                                     size_t min_voxels) const;

 private:
  /// Both pieces and the bridge between them; empty if there is none.
  VoxelComponent joined(const std::vector<VoxelComponent>& ground, const VoxelComponent& body,
                        const VoxelComponent& component) const;

  VoxelLattice lattice_;
  RelaxedVote relaxed_vote_;
};

}  // namespace markerless_mocap
