#pragma once

#include "skeleton/thinning/bit_volume.h"
#include "skeleton/thinning/word_set.h"

/// Cliques of many voxels at once, a bit per voxel. A clique is named by the first voxel, with the
/// lowest coordinates, of the block of 2, 2 x 2 or 2 x 2 x 2 voxels that share its face, edge or
/// corner; the axis of a pair is across its face, that of an edge along it. Words beyond the spans
/// are not written.
namespace markerless_mocap::clique_kernels {

/// By axis; corners under axis 0.
struct CliqueWords {
  BitWords critical[3];
  BitWords isthmus[3];  ///< critical, with two sides of the object around
};

/// Or of all words that were found.
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

/// Clears the candidates in cliques; adds those in joining ones to `isthmuses` if `joining`.
void takeOutPairs(const BitBox& box, const WordSpans& spans, const CliqueWords& cliques,
                  bool isthmus, uint64_t* candidates, uint64_t* isthmuses);
void takeOutEdges(const BitBox& box, const WordSpans& spans, const CliqueWords& cliques,
                  bool isthmus, uint64_t* candidates, uint64_t* isthmuses);
void takeOutCorners(const BitBox& box, const WordSpans& spans, const CliqueWords& cliques,
                    uint64_t* candidates);

}  // namespace markerless_mocap::clique_kernels
