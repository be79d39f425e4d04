#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "hull/selection/voxel_component.h"
#include "hull/voting/projection_table.h"

namespace markerless_mocap {

using Rgb = std::array<uint8_t, 3>;

/// What one camera sees of a piece's surface.
struct SurfaceView {
  std::vector<uint64_t> seen;  ///< voxels per cell
  std::vector<Rgb> rgb;        ///< per slot, valid where seen

  /// Whether the voxel's surface looks at the camera, and where.
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

/// Which cameras see the surface of a hull: a camera sees a voxel when a free face of it looks at
/// the camera and nothing of the hull lies in front of it, by a depth buffer whose cells are about
/// as large as a voxel appears.
class SurfaceVisibility {
 public:
  SurfaceVisibility(const CameraRig& rig, const ProjectionTable& table);

  /// The hull that the following looks are at.
  void set(const VoxelComponent& component);
  /// Memory of the last view is used again.
  void findVisible(size_t camera, const cv::Mat& image, SurfaceView* view) const;
  /// Position in the piece of the cell one leaf further along the axis; -1: it has none there.
  int cellAfter(size_t cell, int axis) const { return after_[cell][axis]; }

 private:
  /// A camera's place, and what turns a voxel's place into its depth.
  struct Viewpoint {
    Eigen::Vector3d position, forward;
    double focal;              ///< px
    float depth_in_brick[64];  ///< m, over that of the leaf's lowest voxel
  };
  void findNeighbors(size_t cell);
  uint64_t facing(const Viewpoint& viewpoint, size_t cell) const;
  float depthOf(const Viewpoint& viewpoint, size_t cell) const;  ///< m, of the lowest voxel
  void findCandidates(size_t camera, SurfaceView* view) const;
  void fillDepths(const Viewpoint& viewpoint, const cv::Mat& image, SurfaceView* view) const;
  template <int kChannels>
  void paintSeen(const cv::Mat& image, SurfaceView* view) const;

  const ProjectionTable& table_;
  std::vector<Viewpoint> viewpoints_;
  BrickVolume volume_;
  VoxelComponent component_;
  std::vector<uint32_t> cell_of_brick_;  ///< valid where volume_ holds voxels
  std::vector<Eigen::Vector3i> corners_;
  std::vector<std::array<int, 3>> after_;
  std::vector<std::array<uint64_t, 6>> free_;  ///< faces without neighbour: -x, +x, -y, +y, -z, +z
};

}  // namespace markerless_mocap
