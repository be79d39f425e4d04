#pragma once

#include "skeleton/thinning/bit_volume.h"
#include "skeleton/thinning/word_set.h"

/// Finds the cliques of many voxels at once, one bit per voxel. A clique is identified by the first
/// voxel (minimum coordinates) of the block of 2, 2 x 2 or 2 x 2 x 2 voxels that share its face,
/// edge or corner. The axis of a pair is across its face, that of an edge along it. Words outside
/// the spans are not written.
namespace markerless_mocap::clique_kernels {

/// Cliques by axis; corners are stored under axis 0.
struct CliqueWords {
  BitWords critical[3];
  BitWords isthmus[3];  ///< critical cliques that connect two sides of the object
};

/// Bitwise or of all words that were found.
struct Found {
  uint64_t critical = 0, isthmus = 0;
};

/// Cliques that consist of candidates.
Found findPairs(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                const uint64_t* candidates, CliqueWords* cliques);
Found findEdges(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                const uint64_t* candidates, CliqueWords* cliques);
Found findCorners(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                  const uint64_t* candidates, CliqueWords* cliques);

/// Clears the candidates in critical cliques; if `isthmus`, adds those in isthmus cliques to
/// `isthmuses`.
void removePairs(const BitBox& box, const WordSpans& spans, const CliqueWords& cliques,
                 bool isthmus, uint64_t* candidates, uint64_t* isthmuses);
void removeEdges(const BitBox& box, const WordSpans& spans, const CliqueWords& cliques,
                 bool isthmus, uint64_t* candidates, uint64_t* isthmuses);
void removeCorners(const BitBox& box, const WordSpans& spans, const CliqueWords& cliques,
                   uint64_t* candidates);

}  // namespace markerless_mocap::clique_kernels
