#pragma once

#include <string>
#include <vector>

#include "hull/selection/person_selection.h"

namespace markerless_mocap {

/// A camera whose mask is wrong.
struct CameraFault {
  size_t camera;
  std::string reason;
};

/// Finds cameras whose masks the others prove wrong, always fewer than half of the present ones:
/// full masks; empty ones, or ones that lack the person, of cameras that see a person whom the
/// others agree on. Costs little while the hull explains the silhouettes.
class FaultFinder {
 public:
  FaultFinder(const CameraRig& rig, int min_views, VoxelVoting* voting);

  struct Result {
    std::vector<VoxelComponent> components;  ///< of the cameras that are left
    CameraSet voters;
    std::vector<CameraFault> faults;
  };
  Result carve(const MaskSummary& masks, const VoxelBox& window);

 private:
  bool mayLeaveOut(CameraSet cameras, CameraSet present) const;
  void leaveOut(CameraSet cameras, const std::string& reason, Result* result) const;
  void leaveOutEmpty(const MaskSummary& masks, const VoxelBox& window, Result* result);
  void leaveOutContradicted(const MaskSummary& masks, const VoxelBox& window, Result* result);
  /// How the tiles are found that a cell reaches. kRoughly finds some of them, never another.
  enum class Reach { kRoughly, kExactly };
  /// Share of the tiles with foreground, of those that look into the volume, that the pieces do not
  /// reach; the median over at most `most` of the cameras, those with the largest silhouettes.
  double unexplained(const std::vector<VoxelComponent>& components, CameraSet voters, int most,
                     Reach how);
  double unexplainedIn(size_t camera, const std::vector<VoxelComponent>& components, Reach how);
  void reachRoughly(size_t camera, const BrickVoxels& cell);
  void reach(size_t camera, const BrickVoxels& cell);

  const CameraRig& rig_;
  int min_views_;
  VoxelVoting* voting_;
  std::vector<std::vector<uint8_t>> looks_in_;  ///< [camera][tile]: into the volume
  std::vector<uint8_t> reached_;
};

}  // namespace markerless_mocap
