#pragma once

#include "hull/voting/projection_table.h"

namespace markerless_mocap {

/// The voxels of the windows whose pixel is set. The pixel of voxel v is at column codes[v] % 16
/// and row codes[v] / 16 of its window.
uint64_t setInWindows(const TileMask& mask, const PixelWindow* begin, const PixelWindow* end,
                      const uint8_t* codes);
/// setInWindows() without vector instructions.
uint64_t setInWindowsPlainly(const TileMask& mask, const PixelWindow* begin, const PixelWindow* end,
                             const uint8_t* codes);

/// The brick's voxels that the camera sees and whose pixels are set.
uint64_t setInBrick(const ProjectionTable& table, const TileMask& mask, size_t brick,
                    size_t camera);

}  // namespace markerless_mocap
