#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

struct Limbs;
struct VoxelGraph;

/// Where the parts of one person were in the frame before. It moves along with the middle of the
/// hull, and is forgotten after a gap and when stamps go back.
class PartMemory {
 public:
  /// Gives arms and legs the numbers that their voxels had in the frame before.
  void number(int64_t stamp_ns, const VoxelGraph& voxels, Limbs* limbs);

  /// Gives limbs that are not among `limbs` the trunk's voxels they had in the frame before, unless
  /// they have not been seen for a third of a second. Call it after number().
  /// \param labels of the nodes
  /// \return by PartLabel, which limbs got some
  std::array<bool, kPartCount> carryOver(int64_t stamp_ns, const VoxelGraph& voxels,
                                         const Limbs& limbs, std::vector<PartLabel>* labels) const;

  /// Keeps this frame for the next one.
  void keep(int64_t stamp_ns, const VoxelGraph& voxels, const Limbs& limbs,
            const std::vector<PartLabel>& labels);

 private:
  /// Where a node would have been in the frame before.
  Eigen::Vector3i placeOf(const Eigen::Vector3d& center, const Eigen::Vector3d& middle) const;
  /// What was nearest to a place, if anything was near.
  PartLabel nearest(const Eigen::Vector3i& place) const;
  bool isNumberedOtherwise(const VoxelGraph& voxels, const Limbs& limbs, PartLabel first) const;
  void findSteps();

  int64_t stamp_ns_ = 0;
  std::array<int64_t, kPartCount> seen_ns_{};
  double pitch_ = 0.0;                  ///< 0: nothing is remembered
  Eigen::Vector3d middle_, corner_;     ///< of the hull; of the box's lowest voxel's centre
  Eigen::Vector3i size_ = {0, 0, 0};    ///< of the box
  std::vector<uint8_t> label_;          ///< of each place of the box
  std::vector<Eigen::Vector3i> steps_;  ///< to places that are near, the nearest first
};

}  // namespace markerless_mocap
