#pragma once

#include "skeleton/critical_cliques.h"

namespace markerless_mocap {

/// Peels an object to curves and sheets of at most two voxels that join or end something, by
/// rounds in which all voxels are judged at once.
class SymmetricPeeling {
 public:
  void peel(const BitBox& box, BitWords* object);

 private:
  void resize(const BitBox& box);
  /// Rows that hold voxels, and those before them along y and z.
  void listSpans(const BitBox& box, const BitWords& object);
  /// Splits the border into simple voxels, and isthmuses and ends to keep.
  void judgeBorder(const BitBox& box, const BitWords& object);
  bool removeCandidates(BitWords* object);

  CriticalCliques cliques_;
  BitWords border_, candidates_, kept_;
  WordSpans spans_, next_spans_;
  std::vector<std::pair<int, int>> rows_;  ///< per plane: first and last row with voxels
};

/// Removes simple voxels, direction by direction, until no simple voxel but ends is left.
class SideThinning {
 public:
  void thin(const BitBox& box, BitWords* object);

 private:
  std::vector<size_t> voxels_, soft_, side_;
};

}  // namespace markerless_mocap
