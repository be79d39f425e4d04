#pragma once

#include <array>
#include <string>
#include <vector>

#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/segmentation/body_segmenter.h"
#include "segmentation/branch.h"
#include "segmentation/voxel_graph.h"

namespace markerless_mocap {

/// Head, arms and legs of a body.
struct Limbs {
  std::array<Branch, kPartCount> branch;                 ///< by PartLabel; without nodes: not found
  std::array<std::vector<double>, kPartCount> geodesic;  ///< from the branch's tip to each node
  std::array<bool, kPartCount> whole{};  ///< by PartLabel: ends where such a limb does
  /// By PartLabel: what was taken for its end is the middle of an arm that closes a loop.
  std::array<bool, kPartCount> loop{};
  int unnamed_loops = 0;  ///< arms that close a loop and have no name
  double cost;            ///< of the names, see PartNaming

  bool has(PartLabel label) const { return !branch[size_t(label)].nodes.empty(); }
};

/// Embeds the graph, finds its branches by the method of the options, and names them. A branch
/// whose size no limb of its name can have is left out. Of two arms (legs) the first is the one
/// whose tip lies further along a fixed slanted direction, so that only where the tips are decides.
Limbs findLimbs(const VoxelGraph& voxels, const SegmentationOptions& options);

}  // namespace markerless_mocap
