#pragma once

#include "skeleton/thinning/critical_cliques.h"

namespace markerless_mocap {

/// Peels an object to curves and sheets of at most two voxels that join or end something, in
/// rounds in which all voxels are judged at once (Bertrand & Couprie 2015).
class SymmetricThinning {
 public:
  /// \param persistence rounds, from 1: a voxel that joins two sides of the object stays for good
  ///   if it is still there so many rounds after it began to (Couprie & Bertrand 2016)
  void thin(const BitBox& box, int persistence, BitWords* object);
  /// Ends of the object as it was, and voxels that joined two sides of it and persisted; some may
  /// not be of the remains.
  const BitWords& kept() const { return kept_; }

 private:
  struct Bits {
    size_t word;
    uint64_t bits;
  };
  struct BorderVoxel {
    uint32_t bit;     ///< its place in the array
    uint32_t around;  ///< its neighbourhood, without itself
  };
  void begin(const BitBox& box, int persistence, const BitWords& object);
  void listBorder(const BitBox& box, const BitWords& object);
  /// Splits the border into candidates, isthmuses, and others.
  void judgeBorder();
  void keepEnds();
  /// Removes the candidates and keeps isthmuses that have persisted. False if there were no
  /// candidates and there are no isthmuses that may yet persist.
  bool finishRound(BitWords* object);

  CriticalCliques cliques_;
  BitWords border_, candidates_, kept_, isthmuses_;
  BitWords seen_;  ///< all that were isthmuses
  WordSet object_words_;
  WordSet candidate_words_;  ///< words that may hold candidates
  WordSpans object_spans_, candidate_spans_;
  std::vector<BorderVoxel> border_voxels_;  ///< the first border_count_ are of this round
  size_t border_count_ = 0;
  std::vector<std::vector<Bits>> fresh_;  ///< isthmuses by the round they came up in, last first
};

/// Removes simple voxels, direction by direction, until no simple voxel is left but ends that are
/// to be kept. As long as it can, it leaves something beside each voxel that it removes, so that
/// curves which are two voxels wide are not eaten up from their ends.
class SideThinning {
 public:
  void thin(const BitBox& box, const BitWords& kept, BitWords* object);

 private:
  bool removable(size_t bit) const;
  /// Whether something of `before_` would have nothing left beside it without this voxel.
  bool alone(size_t bit) const;
  /// True if it has removed something.
  bool thinOnce(bool cover);

  const BitBox* box_ = nullptr;  ///< of the call, as the next two
  const BitWords* kept_ = nullptr;
  BitWords* object_ = nullptr;
  BitWords before_;
  std::vector<size_t> voxels_, soft_, side_;
};

}  // namespace markerless_mocap
