#pragma once

#include "skeleton/critical_cliques.h"

namespace markerless_mocap {

/// Peels an object to curves and sheets of at most two voxels that join or end something, in
/// rounds in which all voxels are judged at once (Bertrand & Couprie 2015).
class SymmetricPeeling {
 public:
  /// \param persistence rounds, from 1: a voxel that joins two sides of the object stays for good
  ///   if it is still there so many rounds after it began to (Couprie & Bertrand 2016)
  void peel(const BitBox& box, int persistence, BitWords* object);

 private:
  struct Bits {
    size_t word;
    uint64_t bits;
  };
  void begin(const BitBox& box, int persistence, const BitWords& object);
  /// Fills `border_voxels_` and `surroundings_`.
  void listBorder(const BitBox& box, const BitWords& object);
  /// Splits the border into candidates, and isthmuses.
  void judgeBorder();
  void keepEnds();
  bool removeCandidates(BitWords* object);
  /// Keeps isthmuses that have persisted. False if there are none, nor any that may yet.
  bool settleIsthmuses(const BitWords& object);

  CriticalCliques cliques_;
  BitWords border_, candidates_, kept_, isthmuses_;
  BitWords seen_;  ///< all that were isthmuses
  WordSet object_words_, candidate_words_;
  WordSpans object_spans_;
  std::vector<size_t> border_voxels_;   ///< places of bits
  std::vector<uint32_t> surroundings_;  ///< of each, without itself
  std::vector<size_t> not_simple_;      ///< numbers of border voxels
  std::vector<std::vector<Bits>>
      fresh_;  ///< isthmuses by the round they were first seen, youngest first
};

/// Removes simple voxels, direction by direction, until no simple voxel but ends is left.
class SideThinning {
 public:
  void thin(const BitBox& box, BitWords* object);

 private:
  std::vector<size_t> voxels_, soft_, side_;
};

}  // namespace markerless_mocap
