#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "hull/selection/voxel_component.h"
#include "hull/voting/projection_table.h"

namespace markerless_mocap {

using Rgb = std::array<uint8_t, 3>;

/// The surface of a component as one camera sees it.
struct SurfaceView {
  std::vector<uint64_t> seen;  ///< visible voxels per cell
  std::vector<Rgb> rgb;        ///< per slot, valid for visible voxels

  /// A voxel with a face that is turned to the camera, and its pixel.
  struct Candidate {
    uint32_t slot;
    uint16_t x, y;
    float depth;  ///< m
  };
  std::vector<uint64_t> facing;  ///< voxels per cell
  std::vector<Candidate> candidates;
  std::vector<float> depths;     ///< the nearest, per cell of the depth buffer
  std::vector<uint32_t> places;  ///< cell of the depth buffer, per candidate
};

/// Finds which cameras see the surface voxels of a hull. A camera sees a voxel if a free face of
/// the voxel is turned to it and no other voxel of the hull occludes it. Occlusion is tested with a
/// depth buffer whose cells are about as large as a voxel in the image.
class SurfaceVisibility {
 public:
  SurfaceVisibility(const CameraRig& rig, const ProjectionTable& table);

  /// Sets the hull for the following calls.
  void set(const VoxelComponent& component);
  /// Reuses the memory of `view`.
  void findVisible(size_t camera, const cv::Mat& image, SurfaceView* view) const;
  /// The same for all voxels whose centre is projected into the image.
  void findAll(size_t camera, const cv::Mat& image, SurfaceView* view) const;
  /// Index of the component's cell one brick further along the axis; -1: none.
  int cellAfter(size_t cell, int axis) const { return after_[cell][axis]; }

 private:
  /// Position of a camera, and what is needed to compute the depth of voxels.
  struct Viewpoint {
    Eigen::Vector3d position, forward;
    double focal;              ///< px
    float depth_in_brick[64];  ///< m, relative to the brick's first voxel
  };
  void findNeighbors(size_t cell);
  uint64_t facing(const Viewpoint& viewpoint, size_t cell) const;
  float depthOf(const Viewpoint& viewpoint, size_t cell) const;  ///< m, of the first voxel
  void findFacing(size_t camera, SurfaceView* view) const;
  /// Of the voxels in view->facing.
  void findCandidates(size_t camera, SurfaceView* view) const;
  void fillDepths(const Viewpoint& viewpoint, const cv::Mat& image, SurfaceView* view) const;
  void color(const cv::Mat& image, SurfaceView* view) const;
  template <int kChannels>
  void colorVisible(const cv::Mat& image, SurfaceView* view) const;

  const ProjectionTable& table_;
  std::vector<Viewpoint> viewpoints_;
  BrickVolume volume_;
  VoxelComponent component_;
  std::vector<uint32_t> cell_of_brick_;  ///< valid for bricks of volume_ with voxels
  std::vector<Eigen::Vector3i> corners_;
  std::vector<std::array<int, 3>> after_;
  std::vector<std::array<uint64_t, 6>> free_;  ///< faces without neighbour: -x, +x, -y, +y, -z, +z
};

}  // namespace markerless_mocap
