#pragma once

#include <vector>

#include "hull/color/surface_visibility.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Computes for each voxel of a hull its mean colour over the cameras that see it, and its colour
/// votes from the cameras that see both voxels, or from all into whose image both are projected. A
/// voxel that no camera sees gets the colour of the previous voxel along x, or, at the start, of
/// the next one; grey if there is none.
class VoxelColoring {
 public:
  VoxelColoring(const CameraRig& rig, const ProjectionTable& table, double color_vote_distance,
                bool all_vote);

  /// Reuses the memory of the last call.
  /// \param order the component's voxels in lattice order
  /// \param images one per camera; empty if the camera has none
  /// \param voxels output, in the same order
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

  void findViews(const std::vector<cv::Mat>& images, bool hidden_too);

  bool all_vote_;
  int limit_;  ///< colours differ from this squared distance on
  SurfaceVisibility visibility_;
  std::vector<SurfaceView> views_;
  std::vector<ColorSum> sums_;     ///< per slot
  std::vector<ColorVotes> votes_;  ///< per slot
};

}  // namespace markerless_mocap
