#pragma once

#include <stddef.h>

#include <cstdint>

#include "skeleton/bit_volume.h"

/// Cliques of many voxels at once, a bit per voxel. A clique is named by the voxel with the lowest
/// coordinates of the block of 2, 2 x 2 or 2 x 2 x 2 voxels that share its face, edge or corner;
/// the axis of a pair is across its face, that of an edge along it. All work on words [begin, end).
namespace markerless_mocap::clique_kernels {

struct Strides {
  ptrdiff_t row, plane;
};

/// Or of all words that were found.
struct Found {
  uint64_t critical = 0, joining = 0;
};

void pairs(int axis, Strides strides, const uint64_t* object, const uint64_t* candidates,
           size_t begin, size_t end, uint64_t* critical, uint64_t* joining, Found* found);
void edges(int axis, Strides strides, const uint64_t* object, const uint64_t* candidates,
           size_t begin, size_t end, uint64_t* critical, uint64_t* joining, Found* found);
void corners(Strides strides, const uint64_t* object, const uint64_t* candidates, size_t begin,
             size_t end, uint64_t* critical, Found* found);

/// Clears in `voxels` those of the cliques, by axis.
void clearPairs(Strides strides, const BitWords (&cliques)[3], size_t begin, size_t end,
                uint64_t* voxels);
void clearEdges(Strides strides, const BitWords (&cliques)[3], size_t begin, size_t end,
                uint64_t* voxels);
void clearCorners(Strides strides, const uint64_t* cliques, size_t begin, size_t end,
                  uint64_t* voxels);
/// Adds the voxels of the cliques.
void addPairs(Strides strides, const BitWords (&cliques)[3], size_t begin, size_t end,
              uint64_t* voxels);
void addEdges(Strides strides, const uint64_t* object, const BitWords (&cliques)[3], size_t begin,
              size_t end, uint64_t* voxels);

}  // namespace markerless_mocap::clique_kernels
