#pragma once

#include <functional>
#include <vector>

#include "hull/selection/voxel_component.h"

namespace markerless_mocap {

/// Joins components of one body that missing votes have separated. Each component of at least
/// `min_voxels` that is not a suspected ghost is joined to the largest one, by the voxels on the
/// shortest paths between the two. The paths lead through all components and through voxels of the
/// relaxed vote, and are shorter than 0.5 m.
class ComponentBridging {
 public:
  /// The foreground in a box if more votes may be missing.
  using RelaxedVote = std::function<const BrickVolume&(const VoxelBox&)>;

  ComponentBridging(const VoxelLattice& lattice, RelaxedVote relaxed_vote)
      : lattice_(lattice), relaxed_vote_(std::move(relaxed_vote)) {}

  /// \param components largest first
  /// \return in the same order; the first one contains all that was joined
  std::vector<VoxelComponent> bridge(std::vector<VoxelComponent> components,
                                     size_t min_voxels) const;

 private:
  /// Both components and the bridge between them; empty if there is no bridge.
  VoxelComponent joined(const std::vector<VoxelComponent>& ground, const VoxelComponent& body,
                        const VoxelComponent& component) const;

  VoxelLattice lattice_;
  RelaxedVote relaxed_vote_;
};

}  // namespace markerless_mocap
