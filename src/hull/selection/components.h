#pragma once

#include <vector>

#include "hull/selection/voxel_component.h"

namespace markerless_mocap {

/// 26-connected components of a volume, by union-find over the connected parts of its bricks.
class ComponentFinder {
 public:
  /// Components sorted by size, largest first; components of equal size by their first linear
  /// index. Reuses the memory of the last call.
  std::vector<VoxelComponent> find(const BrickVolume& volume, const VoxelLattice& lattice);

 private:
  void listParts(const BrickVolume& volume);
  /// Joins the parts of a brick with those of the neighbours that come before it.
  void joinBackwards(const BrickVolume& volume, const Eigen::Vector3i& at, size_t brick);
  void joinTouching(uint32_t brick, uint32_t other, const int (&step)[3]);

  std::vector<BrickVoxels> parts_;      ///< connected within their brick, in the order of bricks
  std::vector<uint32_t> parents_;       ///< per part
  std::vector<uint32_t> first_part_;    ///< per brick that holds voxels; other entries are not read
  std::vector<uint32_t> component_of_;  ///< per part that is a root of the union-find forest
};

}  // namespace markerless_mocap
