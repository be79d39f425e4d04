#pragma once

#include <functional>
#include <vector>

#include "hull/selection/piece.h"

namespace markerless_mocap {

/// Joins pieces of one body that a lost vote has cut apart. Each further piece of at least
/// `least_voxels` that is no suspect ghost is joined to the largest one by the voxels on the
/// shortest ways between the two through `loose` and all pieces, if any are shorter than 0.5 m.
class PieceBridging {
 public:
  /// What stands in a box when more votes may be missing.
  using LooseVote = std::function<const LeafVolume&(const VoxelBox&)>;

  PieceBridging(const VoxelLattice& lattice, LooseVote loose_vote)
      : lattice_(lattice), loose_vote_(std::move(loose_vote)) {}

  /// \param pieces largest first \return in the same order, what was joined in the first one
  std::vector<Piece> bridge(std::vector<Piece> pieces, size_t least_voxels) const;

 private:
  /// Both pieces and the bridge between them; empty if there is none.
  Piece joined(const std::vector<Piece>& ground, const Piece& body, const Piece& piece) const;

  VoxelLattice lattice_;
  LooseVote loose_vote_;
};

}  // namespace markerless_mocap
