#pragma once

#include "hull/carving_plan.h"

namespace markerless_mocap {

/// Which of 64 voxels have their pixel set: voxel v's is at column codes[v] % 16 and row
/// codes[v] / 16 of the window of 16 x 16 pixels at (x, y).
uint64_t setInWindow(const BitMask& mask, int x, int y, const uint8_t* codes);
/// setInWindow() without vector instructions.
uint64_t setInWindowPlainly(const BitMask& mask, int x, int y, const uint8_t* codes);

/// The leaf's voxels whose pixels in the camera are set; none that it does not see.
uint64_t setInLeaf(const CarvingPlan& plan, const BitMask& mask, size_t leaf, size_t camera);

}  // namespace markerless_mocap
