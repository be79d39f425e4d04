#pragma once

#include <vector>

#include "hull/color/surface_visibility.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Gives the voxels of a hull their mean colour over the cameras that see them, and their colour
/// votes, by the cameras that see both voxels. Voxels that no camera sees take the colour of the
/// voxel before them along x, the first ones that of the next, grey where there is none.
class VoxelColoring {
 public:
  VoxelColoring(const CameraRig& rig, const ProjectionTable& table, double color_vote_distance);

  /// Memory of the last call is used again.
  /// \param order the piece's voxels in lattice order
  /// \param images one per camera; empty where there is none
  /// \param voxels in the same order
  void paint(const VoxelComponent& component, const std::vector<ComponentVoxel>& order,
             const std::vector<cv::Mat>& images, std::vector<HullVoxel>* voxels);

 private:
  /// Sum of colours of one voxel.
  struct ColorSum {
    uint16_t rgb[3] = {0, 0, 0};
    uint16_t count = 0;

    void add(const Rgb& color);
    Rgb mean() const;
  };

  void sumColors(size_t cells);
  void setColors(const std::vector<ComponentVoxel>& order, std::vector<HullVoxel>* voxels) const;
  void addVotes(const SurfaceView& view, int axis);

  int limit_;  ///< squared distance from which on colours differ
  SurfaceVisibility visibility_;
  std::vector<SurfaceView> views_;
  std::vector<ColorSum> sums_;     ///< per slot
  std::vector<ColorVotes> votes_;  ///< per slot
};

}  // namespace markerless_mocap
