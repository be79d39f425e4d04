#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

struct Limbs;
struct VoxelGraph;

/// Positions of the parts of one person in the previous frame. They are moved along with the centre
/// of the hull, and discarded after a gap in time or if stamps go back.
class PartMemory {
 public:
  /// Gives arms and legs the numbers that their voxels had in the previous frame.
  void number(int64_t stamp_ns, const VoxelGraph& voxels, Limbs* limbs);

  /// Labels voxels of the trunk as a limb that is not among `limbs`, where that limb was in the
  /// previous frame, for up to a third of a second after it was last seen. Call it after number().
  /// \param labels labels of the nodes, by node
  /// \return by PartLabel: whether voxels were given to this limb
  std::array<bool, kPartCount> carryOver(int64_t stamp_ns, const VoxelGraph& voxels,
                                         const Limbs& limbs, std::vector<PartLabel>* labels) const;

  /// Stores this frame for the next one.
  void keep(int64_t stamp_ns, const VoxelGraph& voxels, const Limbs& limbs,
            const std::vector<PartLabel>& labels);

 private:
  /// Cell of the box where a node would have been in the previous frame.
  Eigen::Vector3i placeOf(const Eigen::Vector3d& center, const Eigen::Vector3d& middle) const;
  /// Label nearest to a cell, if there is one nearby.
  PartLabel nearest(const Eigen::Vector3i& place) const;
  bool isNumberedOtherwise(const VoxelGraph& voxels, const Limbs& limbs, PartLabel first) const;
  void findSteps();

  int64_t stamp_ns_ = 0;
  std::array<int64_t, kPartCount> seen_ns_{};
  double pitch_ = 0.0;                  ///< 0: no frame is stored
  Eigen::Vector3d middle_, corner_;     ///< centre of the hull; centre of the box's first voxel; m
  Eigen::Vector3i size_ = {0, 0, 0};    ///< of the box
  std::vector<uint8_t> label_;          ///< of each cell of the box
  std::vector<Eigen::Vector3i> steps_;  ///< to nearby cells, the nearest first
};

}  // namespace markerless_mocap
