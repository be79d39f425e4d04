#pragma once

#include "skeleton/bit_volume.h"

/// Cliques of many voxels at once, a bit per voxel. A clique is named by the first voxel, with the
/// lowest coordinates, of the block of 2, 2 x 2 or 2 x 2 x 2 voxels that share its face, edge or
/// corner; the axis of a pair is across its face, that of an edge along it. All work on words
/// [begin, end).
namespace markerless_mocap::clique_kernels {

struct Cliques {
  uint64_t *critical, *joining;
};

/// Or of all words that were found.
struct Found {
  uint64_t critical = 0, joining = 0;
};

/// Cliques that consist of candidates.
void pairs(const BitBox& box, int axis, size_t begin, size_t end, const uint64_t* object,
           const uint64_t* candidates, Cliques cliques, Found* found);
void edges(const BitBox& box, int axis, size_t begin, size_t end, const uint64_t* object,
           const uint64_t* candidates, Cliques cliques, Found* found);
void corners(const BitBox& box, size_t begin, size_t end, const uint64_t* object,
             const uint64_t* candidates, uint64_t* critical, Found* found);

/// Clears in `candidates` the voxels of the cliques, by axis.
void clearPairs(const BitBox& box, const BitWords (&cliques)[3], size_t begin, size_t end,
                uint64_t* candidates);
void clearEdges(const BitBox& box, const BitWords (&cliques)[3], size_t begin, size_t end,
                uint64_t* candidates);
void clearCorners(const BitBox& box, const BitWords& cliques, size_t begin, size_t end,
                  uint64_t* candidates);
/// Adds to `voxels` the candidates in the cliques.
void addPairs(const BitBox& box, const BitWords (&cliques)[3], size_t begin, size_t end,
              const uint64_t* candidates, uint64_t* voxels);
void addEdges(const BitBox& box, const BitWords (&cliques)[3], size_t begin, size_t end,
              const uint64_t* candidates, uint64_t* voxels);

}  // namespace markerless_mocap::clique_kernels
