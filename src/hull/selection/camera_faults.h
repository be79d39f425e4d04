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

/// Finds cameras whose masks contradict the masks of the others; always fewer than half of the
/// present cameras. A mask is wrong if it is full, or if the other cameras agree on a person in the
/// camera's view and the mask is empty or lacks that person. The test is cheap if the hull explains
/// the silhouettes.
class FaultyCameraFinder {
 public:
  FaultyCameraFinder(const CameraRig& rig, int min_views, VoxelVoting* voting);

  struct Result {
    std::vector<VoxelComponent> components;  ///< carved with the cameras that are left
    CameraSet voters;
    std::vector<CameraFault> faults;
  };
  Result carve(const MaskSummary& masks, const VoxelBox& window);

 private:
  bool mayLeaveOut(CameraSet cameras, CameraSet present) const;
  void leaveOut(CameraSet cameras, const std::string& reason, Result* result) const;
  void leaveOutEmpty(const MaskSummary& masks, const VoxelBox& window, Result* result);
  void leaveOutContradicted(const MaskSummary& masks, const VoxelBox& window, Result* result);
  /// How to find the tiles that a cell covers. kRoughly finds a subset of them.
  enum class Reach { kRoughly, kExactly };
  /// Fraction of the tiles with foreground that the components do not cover, among the tiles that
  /// see a part of the volume; median over up to `max_cameras` cameras, those with the largest
  /// silhouettes.
  double unexplained(const std::vector<VoxelComponent>& components, CameraSet voters,
                     int max_cameras, Reach how);
  double unexplainedIn(size_t camera, const std::vector<VoxelComponent>& components, Reach how);
  void reachRoughly(size_t camera, const BrickVoxels& cell);
  void reach(size_t camera, const BrickVoxels& cell);

  const CameraRig& rig_;
  int min_views_;
  VoxelVoting* voting_;
  /// [camera][tile]: whether it sees a part of the volume.
  std::vector<std::vector<uint8_t>> looks_in_;
  std::vector<uint8_t> reached_;
};

}  // namespace markerless_mocap
