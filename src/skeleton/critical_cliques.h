#pragma once

#include <utility>
#include <vector>

#include "skeleton/bit_volume.h"

namespace markerless_mocap {

/// Words [first, second) of a volume, several rows of one plane.
using WordSpans = std::vector<std::pair<size_t, size_t>>;

/// Finds what cannot go together. A clique is all voxels of the object that share a face, an edge
/// or a corner; it is critical when the object's voxels around that touch all of it do not shrink
/// to one point. If a voxel of every critical clique stays, the simple voxels may go at once and
/// the topology is the same (Bertrand & Couprie 2006).
class CriticalCliques {
 public:
  explicit CriticalCliques(const BitBox& box);
  CriticalCliques() = default;

  /// Takes from `candidates` all voxels of critical cliques of which no voxel stays anyway; first
  /// those of faces, then of edges, then of corners.
  /// \param spans of all rows that hold voxels and of those before them along y and z
  /// \param candidates simple voxels of the object; only rows of spans are written
  /// \param isthmuses gets the voxels of cliques that join two sides of the object
  void keep(const WordSpans& spans, const BitWords& object, BitWords* candidates,
            BitWords* isthmuses);

 private:
  void keepPairs(const WordSpans& spans, const BitWords& object, BitWords* candidates,
                 BitWords* isthmuses);
  void keepEdges(const WordSpans& spans, const BitWords& object, BitWords* candidates,
                 BitWords* isthmuses);
  void keepCorners(const WordSpans& spans, const BitWords& object, BitWords* candidates);

  BitBox box_;
  /// By axis, at the voxel of a clique with the lowest coordinates: critical; joining two sides.
  BitWords critical_[3], joining_[3];
};

}  // namespace markerless_mocap
