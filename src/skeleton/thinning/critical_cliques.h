#pragma once

#include "skeleton/thinning/clique_kernels.h"

namespace markerless_mocap {

/// Finds voxels that must not be removed at the same time. A clique is the set of all voxels of the
/// object that share a face, an edge or a corner. It is critical if the voxels of the object that
/// touch all of it do not shrink to one point. If one voxel of each critical clique is kept, all
/// other simple voxels can be removed at once without a change of topology (Bertrand & Couprie
/// 2006).
class CriticalCliques {
 public:
  void resize(const BitBox& box);

  /// Removes from `candidates` all voxels of critical cliques that consist of candidates only:
  /// first those of faces, then of edges, then of corners.
  /// \param candidate_words words that may hold candidates
  /// \param candidates simple voxels of the object
  /// \param isthmuses output, voxels of cliques that connect two sides of the object
  void keep(const WordSet& candidate_words, const BitWords& object, BitWords* candidates,
            BitWords* isthmuses);

 private:
  void listSpans(const WordSet& candidate_words);

  BitBox box_;
  WordSet words_;    ///< words that may hold the first voxel of a clique of candidates
  WordSpans spans_;  ///< the same
  clique_kernels::CliqueWords cliques_;  ///< outside the spans, words of earlier rounds
};

}  // namespace markerless_mocap
