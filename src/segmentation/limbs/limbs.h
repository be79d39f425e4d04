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
  std::array<Branch, kPartCount> branch;  ///< by PartLabel; no nodes: not found
  /// From the branch's extremity to each node.
  std::array<std::vector<double>, kPartCount> geodesic;
  std::array<bool, kPartCount> whole{};  ///< by PartLabel: whether the limb has its whole length
  /// By PartLabel: whether its extremity is in fact the middle of an arm that closes a loop.
  std::array<bool, kPartCount> loop{};
  int unnamed_loops = 0;  ///< arms that close a loop and are not assigned
  double cost;            ///< of the assignment, see PartNaming

  bool has(PartLabel label) const { return !branch[size_t(label)].nodes.empty(); }
};

/// Embeds the graph, finds its branches by the method of the options, and assigns them to parts. A
/// branch with a size that is implausible for its part is left out. Of two arms (legs) the first is
/// the one whose extremity lies further along a fixed slanted direction, so the order depends on
/// positions only.
Limbs findLimbs(const VoxelGraph& voxels, const SegmentationOptions& options);

}  // namespace markerless_mocap
