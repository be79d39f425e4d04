#include "hull/voting/projection_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "hull/voting/brick_projection.h"

namespace markerless_mocap {
namespace {

/// Adds the windows that hold pixels, of a raster of 16 x 16 pixels that starts at (x0, y0).
void addWindows(const VoxelPixel* pixels, int count, int x0, int y0,
                std::vector<PixelWindow>* windows, uint8_t* codes) {
  const size_t first = windows->size();
  for (int i = 0; i < count; ++i) {
    const VoxelPixel& p = pixels[i];
    const uint16_t x = uint16_t(x0 + (p.x - x0) / 16 * 16), y = uint16_t(y0 + (p.y - y0) / 16 * 16);
    auto window = std::find_if(windows->begin() + first, windows->end(),
                               [&](const PixelWindow& w) { return w.x == x && w.y == y; });
    if (window == windows->end()) window = windows->insert(windows->end(), {0, x, y});
    window->voxels |= uint64_t(1) << p.voxel;
    codes[p.voxel] = uint8_t(p.x - x + 16 * (p.y - y));
  }
}

}  // namespace

ProjectionTable::ProjectionTable(const CameraRig& rig, const VoxelLattice& lattice)
    : lattice_(lattice), cameras_(rig.size()) {
  resize();
  std::vector<BrickProjection> projections;
  for (const Camera& camera : rig) projections.emplace_back(camera, lattice_);
  std::vector<Layer> layers(levels_[0].size.z());
  tbb::parallel_for(size_t(0), layers.size(),
                    [&](size_t z) { fillLayer(projections, int(z), &layers[z]); });
  first_window_.reserve(size_t(levels_[0].size.prod()) * cameras_ + 1);
  first_window_.push_back(0);
  size_t windows = 0;
  for (const Layer& layer : layers) windows += layer.windows.size();
  windows_.reserve(windows);
  for (Layer& layer : layers) {
    for (const uint32_t count : layer.counts) first_window_.push_back(first_window_.back() + count);
    windows_.insert(windows_.end(), layer.windows.begin(), layer.windows.end());
    layer = Layer();
  }
  for (int i = 1; i < kLevels; ++i) fillLevel(levels_[i - 1], &levels_[i]);
}

void ProjectionTable::resize() {
  Eigen::Vector3i size = lattice_.size;
  for (int i = 0; i < kLevels; ++i) {
    size = ((size.array() + (i == 0 ? kBrickSide : 2) - 1) / (i == 0 ? kBrickSide : 2)).eval();
    BlockLevel& level = levels_[i];
    level.size = size;
    const size_t blocks = size_t(size.x()) * size.y() * size.z();
    level.sees_some.assign(blocks, 0);
    level.sees_all.assign(blocks, 0);
    level.tiles.assign(blocks * cameras_, TileBox());
    if (i == 0) codes_.assign(blocks * cameras_ * 64, 0);
  }
}

void ProjectionTable::fillLayer(const std::vector<BrickProjection>& projections, int z,
                                Layer* layer) {
  BlockLevel& bricks = levels_[0];
  for (int y = 0; y < bricks.size.y(); ++y)
    for (int x = 0; x < bricks.size.x(); ++x) {
      const size_t brick = bricks.blockAt(x, y, z);
      for (size_t c = 0; c < cameras_; ++c)
        fillBrick(projections[c], brick * cameras_ + c, kBrickSide * Eigen::Vector3i(x, y, z),
                  layer);
    }
}

void ProjectionTable::fillBrick(const BrickProjection& projection, size_t index,
                                const Eigen::Vector3i& corner, Layer* layer) {
  VoxelPixel pixels[BrickProjection::kVoxels];
  const int count = projection.project(corner, pixels);
  const size_t before = layer->windows.size();
  if (count > 0) {
    int x0 = pixels[0].x, x1 = x0, y0 = pixels[0].y, y1 = y0;
    for (int i = 1; i < count; ++i) {
      x0 = std::min(x0, pixels[i].x), x1 = std::max(x1, pixels[i].x);
      y0 = std::min(y0, pixels[i].y), y1 = std::max(y1, pixels[i].y);
    }
    addWindows(pixels, count, x0, y0, &layer->windows, &codes_[index * 64]);
    levels_[0].tiles[index] = {uint16_t(x0 / 8), uint16_t(y0 / 8), uint16_t(x1 / 8 + 1),
                               uint16_t(y1 / 8 + 1)};
    const uint32_t bit = 1u << (index % cameras_);
    const Eigen::Vector3i end = (corner.array() + kBrickSide).min(lattice_.size.array());
    levels_[0].sees_some[index / cameras_] |= bit;
    if (count == (end - corner).prod()) levels_[0].sees_all[index / cameras_] |= bit;
  }
  layer->counts.push_back(uint32_t(layer->windows.size() - before));
}

void ProjectionTable::fillLevel(const BlockLevel& below, BlockLevel* level) const {
  std::fill(level->sees_all.begin(), level->sees_all.end(), ~uint32_t(0));
  for (int z = 0; z < below.size.z(); ++z)
    for (int y = 0; y < below.size.y(); ++y)
      for (int x = 0; x < below.size.x(); ++x) {
        const size_t child = below.blockAt(x, y, z), block = level->blockAt(x / 2, y / 2, z / 2);
        level->sees_some[block] |= below.sees_some[child];
        level->sees_all[block] &= below.sees_all[child];
        for (size_t c = 0; c < cameras_; ++c)
          level->tiles[block * cameras_ + c].add(below.tiles[child * cameras_ + c]);
      }
}

size_t ProjectionTable::bytes() const {
  size_t sum = codes_.capacity() + windows_.capacity() * sizeof(PixelWindow) +
               first_window_.capacity() * sizeof(uint32_t);
  for (const BlockLevel& level : levels_)
    sum += (level.sees_some.capacity() + level.sees_all.capacity()) * sizeof(CameraSet) +
           level.tiles.capacity() * sizeof(TileBox);
  return sum;
}

uint64_t ProjectionTable::seen(size_t brick, size_t camera) const {
  uint64_t voxels = 0;
  for (const PixelWindow* w = windowsBegin(brick, camera); w != windowsEnd(brick, camera); ++w)
    voxels |= w->voxels;
  return voxels;
}

}  // namespace markerless_mocap
