#pragma once

#include "skeleton/thinning/critical_cliques.h"

namespace markerless_mocap {

/// Thins an object to curves and sheets that are up to two voxels wide, in rounds in which all
/// voxels are tested in parallel (symmetric scheme of Bertrand & Couprie 2015).
class SymmetricThinning {
 public:
  /// \param persistence number of rounds, at least 1: an isthmus, a voxel that connects two sides
  ///   of the object, is kept permanently if it still exists this many rounds after it became one
  ///   (Couprie & Bertrand 2016)
  void thin(const BitBox& box, int persistence, BitWords* object);
  /// Ends of the object before thinning, and isthmuses that persisted. Some may not be in the
  /// result.
  const BitWords& kept() const { return kept_; }

 private:
  struct Bits {
    size_t word;
    uint64_t bits;
  };
  struct BorderVoxel {
    uint32_t bit;     ///< its index in the array
    uint32_t around;  ///< its neighbourhood, without the voxel itself
  };
  void begin(const BitBox& box, int persistence, const BitWords& object);
  void listBorder(const BitBox& box, const BitWords& object);
  /// Splits the border into candidates, isthmuses and other voxels.
  void classifyBorder();
  void keepEnds();
  /// Removes the candidates and keeps isthmuses that have persisted. Returns false if there were no
  /// candidates and no isthmus can persist any more.
  bool finishRound(BitWords* object);

  CriticalCliques cliques_;
  BitWords border_, candidates_, kept_, isthmuses_;
  BitWords seen_;  ///< all voxels that were isthmuses
  WordSet object_words_;
  WordSet candidate_words_;  ///< words that may hold candidates
  WordSpans object_spans_, candidate_spans_;
  /// The first border_count_ entries are valid in this round.
  std::vector<BorderVoxel> border_voxels_;
  size_t border_count_ = 0;
  /// Isthmuses by the round in which they were found, last first.
  std::vector<std::vector<Bits>> new_isthmuses_;
};

/// Removes simple voxels, direction by direction, until only ends that are to be kept are simple.
/// As long as possible, each removed voxel keeps a neighbour, so that curves two voxels wide are
/// not shortened from their ends.
class SideThinning {
 public:
  void thin(const BitBox& box, const BitWords& kept, BitWords* object);

 private:
  bool removable(size_t bit) const;
  /// Whether a voxel of `before_` would have no neighbour left without this voxel.
  bool alone(size_t bit) const;
  /// Returns whether a voxel was removed.
  bool thinOnce(bool cover);

  const BitBox* box_ = nullptr;  ///< argument of the current call, as are the next two
  const BitWords* kept_ = nullptr;
  BitWords* object_ = nullptr;
  BitWords before_;
  std::vector<size_t> voxels_, soft_, side_;
};

}  // namespace markerless_mocap
