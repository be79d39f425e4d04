#pragma once

#include "skeleton/thinning/clique_kernels.h"

namespace markerless_mocap {

/// Finds what cannot go together. A clique is all voxels of the object that share a face, an edge
/// or a corner; it is critical when the object's voxels around that touch all of it do not shrink
/// to one point. If a voxel of every critical clique stays, the simple voxels may go at once and
/// the topology is the same (Bertrand & Couprie 2006).
class CriticalCliques {
 public:
  void resize(const BitBox& box);

  /// Takes from `candidates` all voxels of critical cliques of which no voxel stays anyway; first
  /// those of faces, then of edges, then of corners.
  /// \param candidate_words that hold candidates
  /// \param candidates simple voxels of the object
  /// \param isthmuses gets the voxels of cliques that join two sides of the object
  void keep(const WordSet& candidate_words, const BitWords& object, BitWords* candidates,
            BitWords* isthmuses);

 private:
  void listSpans(const WordSet& candidate_words);

  BitBox box_;
  WordSet words_;                        ///< where the first voxel of a clique of candidates may be
  WordSpans spans_;                      ///< the same
  clique_kernels::CliqueWords cliques_;  ///< of other rounds beyond the spans
};

}  // namespace markerless_mocap
