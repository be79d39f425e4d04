#pragma once

#include <vector>

#include "hull/voting/brick_words.h"
#include "hull/voting/tile_mask.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

class BrickProjection;

/// A set of cameras; bit c is camera c.
using CameraSet = uint32_t;

/// Voxels of one brick whose pixels in one camera lie in one window of 16 x 16 pixels.
struct PixelWindow {
  uint64_t voxels;
  uint16_t x, y;  ///< pixel of the window's corner
};

/// The blocks of one size, and what each camera sees of them.
struct BlockLevel {
  Eigen::Vector3i size;              ///< blocks
  std::vector<CameraSet> sees_some;  ///< per block: cameras that see at least one voxel
  std::vector<CameraSet> sees_all;
  /// [block][camera]: bounding box, in tiles, of the pixels of the voxels it sees.
  std::vector<TileBox> tiles;

  size_t blockAt(int x, int y, int z) const { return (size_t(z) * size.y() + y) * size.x() + x; }
};

/// Look-up table of the pixel at which each camera of a rig sees each voxel of a lattice: the pixel
/// nearest to the projection of the voxel's centre, with lens distortion. It is stored as a
/// rectangle of tiles per block of an octree, and as one byte per voxel and camera. Depends on rig
/// and lattice only.
class ProjectionTable {
 public:
  ProjectionTable(const CameraRig& rig, const VoxelLattice& lattice);

  static constexpr int kLevels = 4;  ///< blocks with sides of 4 (bricks), 8, 16 and 32 voxels
  const BlockLevel& level(int i) const { return levels_[i]; }
  const VoxelLattice& lattice() const { return lattice_; }
  size_t cameras() const { return cameras_; }

  /// Pixel of each of the brick's voxels within its window: column + 16 * row.
  const uint8_t* codes(size_t brick, size_t camera) const {
    return &codes_[(brick * cameras_ + camera) * 64];
  }
  const PixelWindow* windowsBegin(size_t brick, size_t camera) const {
    return windows_.data() + first_window_[brick * cameras_ + camera];
  }
  const PixelWindow* windowsEnd(size_t brick, size_t camera) const {
    return windows_.data() + first_window_[brick * cameras_ + camera + 1];
  }
  /// Memory that the table uses.
  size_t bytes() const;
  /// The brick's voxels that the camera sees.
  uint64_t seen(size_t brick, size_t camera) const;

 private:
  /// The windows of one layer of bricks; layers are computed in parallel.
  struct Layer {
    std::vector<PixelWindow> windows;
    std::vector<uint32_t> counts;  ///< windows per brick and camera
  };

  void resize();
  void fillLayer(const std::vector<BrickProjection>& projections, int z, Layer* layer);
  void fillBrick(const BrickProjection& projection, size_t index, const Eigen::Vector3i& corner,
                 Layer* layer);
  void fillLevel(const BlockLevel& below, BlockLevel* level) const;

  VoxelLattice lattice_;
  size_t cameras_;
  BlockLevel levels_[kLevels];
  std::vector<uint8_t> codes_;
  std::vector<PixelWindow> windows_;
  std::vector<uint32_t> first_window_;
};

}  // namespace markerless_mocap
