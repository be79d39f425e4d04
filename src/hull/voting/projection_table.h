#pragma once

#include <vector>

#include "hull/voting/brick_words.h"
#include "hull/voting/tile_mask.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

/// Cameras as bits.
using CameraSet = uint32_t;

/// Voxels of one leaf whose pixels in one camera lie in one window of 16 x 16 pixels.
struct PixelWindow {
  uint64_t voxels;
  uint16_t x, y;  ///< pixel of the window's corner
};

/// One size of blocks: what each camera sees of each block.
struct BlockLevel {
  Eigen::Vector3i size;              ///< blocks
  std::vector<CameraSet> sees_some;  ///< per block: cameras that see at least one voxel
  std::vector<CameraSet> sees_all;
  std::vector<TileBox> tiles;  ///< [block][camera], tiles of the pixels of the voxels it sees

  size_t blockAt(int x, int y, int z) const { return (size_t(z) * size.y() + y) * size.x() + x; }
};

/// Where each camera of a rig sees each voxel of a lattice (nearest pixel of the voxel's centre,
/// lens distortion included), in the forms that carving asks for: tiles per block of an octree, and
/// one byte per voxel and camera. Depends on nothing but rig and lattice.
class ProjectionTable {
 public:
  ProjectionTable(const CameraRig& rig, const VoxelLattice& lattice);

  static constexpr int kLevels = 4;  ///< blocks of 4 (leaves), 8, 16 and 32 voxels
  const BlockLevel& level(int i) const { return levels_[i]; }
  const VoxelLattice& lattice() const { return lattice_; }
  size_t cameras() const { return cameras_; }

  /// Pixel within its window of each of the leaf's voxels: column + 16 * row.
  const uint8_t* codes(size_t brick, size_t camera) const {
    return &codes_[(brick * cameras_ + camera) * 64];
  }
  const PixelWindow* windowsBegin(size_t brick, size_t camera) const {
    return windows_.data() + first_window_[brick * cameras_ + camera];
  }
  const PixelWindow* windowsEnd(size_t brick, size_t camera) const {
    return windows_.data() + first_window_[brick * cameras_ + camera + 1];
  }
  /// Memory that the plan holds.
  size_t bytes() const;
  /// The leaf's voxels that the camera sees.
  uint64_t seen(size_t brick, size_t camera) const;

 private:
  /// What one layer of leaves needs; layers are made in parallel.
  struct Layer {
    std::vector<PixelWindow> windows;
    std::vector<uint32_t> counts;  ///< windows per leaf and camera
  };

  void resize();
  void fillLayer(const CameraRig& rig, int z, Layer* layer);
  void fillBrick(const Camera& camera, size_t index, const Eigen::Vector3i& corner, Layer* layer);
  void fillLevel(const BlockLevel& below, BlockLevel* level) const;

  VoxelLattice lattice_;
  size_t cameras_;
  BlockLevel levels_[kLevels];
  std::vector<uint8_t> codes_;
  std::vector<PixelWindow> windows_;
  std::vector<uint32_t> first_window_;
};

}  // namespace markerless_mocap
