#include "hull/color/surface_visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace markerless_mocap {
namespace {

/// A face is turned to a camera if the cosine between its normal and the ray is at least this.
constexpr double kMinCosine = 0.3;
/// Voxels up to this far behind the nearest one of their cell are visible; in voxels.
constexpr double kBehind = 2.0;
/// Side of a depth buffer cell, in voxels at the component's smallest distance.
constexpr double kCell = 1.25;
constexpr float kFar = std::numeric_limits<float>::max();

}  // namespace

SurfaceVisibility::SurfaceVisibility(const CameraRig& rig, const ProjectionTable& table)
    : table_(table), volume_(table.lattice()), cell_of_brick_(volume_.count()) {
  const VoxelLattice& lattice = table.lattice();
  const Eigen::Vector3d middle = lattice.origin + 0.5 * lattice.pitch * lattice.size.cast<double>();
  for (const Camera& camera : rig) {
    Viewpoint v;
    v.position = camera.position();
    const LocalView view = camera.localView(middle);
    v.forward = view.R_world_view.col(2);
    v.focal = std::max(view.fx, view.fy);
    for (int bit = 0; bit < 64; ++bit)
      v.depth_in_brick[bit] = float(
          table.lattice().pitch * v.forward.dot(Eigen::Vector3d(bit & 3, bit >> 2 & 3, bit >> 4)));
    viewpoints_.push_back(v);
  }
}

void SurfaceVisibility::set(const VoxelComponent& component) {
  component_ = component;
  volume_.clear();
  corners_.clear();
  for (size_t i = 0; i < component.cells.size(); ++i) {
    const BrickVoxels& cell = component.cells[i];
    corners_.push_back(cornerOf(table_.lattice(), cell.brick));
    const Eigen::Vector3i at = corners_.back() / kBrickSide;
    volume_.set(at.x(), at.y(), at.z(), cell.voxels);
    cell_of_brick_[cell.brick] = uint32_t(i);
  }
  after_.resize(component.cells.size());
  free_.resize(component.cells.size());
  for (size_t i = 0; i < component.cells.size(); ++i) findNeighbors(i);
}

void SurfaceVisibility::findNeighbors(size_t cell) {
  using namespace brick_words;
  const uint64_t word = component_.cells[cell].voxels;
  const Eigen::Vector3i& size = volume_.size();
  const size_t stride[3] = {1, size_t(size.x()), size_t(size.x()) * size_t(size.y())};
  for (size_t axis = 0; axis < 3; ++axis) {
    const size_t brick = component_.cells[cell].brick;
    const int at = corners_[cell][axis] / kBrickSide, far = (kBrickSide - 1) * kStep[axis];
    const uint64_t below = at > 0 ? volume_.word(brick - stride[axis]) : 0;
    const uint64_t above = at + 1 < size[axis] ? volume_.word(brick + stride[axis]) : 0;
    free_[cell][2 * axis] = word & ~(up(word, axis) | (below & kHighFace[axis]) >> far);
    free_[cell][2 * axis + 1] = word & ~(down(word, axis) | (above & kLowFace[axis]) << far);
    after_[cell][axis] = above != 0 ? int(cell_of_brick_[brick + stride[axis]]) : -1;
  }
}

uint64_t SurfaceVisibility::facing(const Viewpoint& viewpoint, size_t cell) const {
  const VoxelLattice& lattice = table_.lattice();
  const Eigen::Vector3d middle =
      lattice.origin +
      lattice.pitch * (corners_[cell].cast<double>().array() + kBrickSide / 2.0).matrix();
  const Eigen::Vector3d to_camera = viewpoint.position - middle;
  const double min_distance = kMinCosine * to_camera.norm();
  uint64_t voxels = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    if (to_camera[axis] < -min_distance) voxels |= free_[cell][2 * axis];
    if (to_camera[axis] > min_distance) voxels |= free_[cell][2 * axis + 1];
  }
  return voxels;
}

float SurfaceVisibility::depthOf(const Viewpoint& viewpoint, size_t cell) const {
  const VoxelLattice& lattice = table_.lattice();
  const Eigen::Vector3d first_voxel =
      lattice.origin + lattice.pitch * (corners_[cell].cast<double>().array() + 0.5).matrix();
  return float(viewpoint.forward.dot(first_voxel - viewpoint.position));
}

void SurfaceVisibility::findFacing(size_t camera, SurfaceView* view) const {
  view->facing.resize(corners_.size());
  for (size_t i = 0; i < corners_.size(); ++i) view->facing[i] = facing(viewpoints_[camera], i);
}

void SurfaceVisibility::findCandidates(size_t camera, SurfaceView* view) const {
  const Viewpoint& viewpoint = viewpoints_[camera];
  size_t count = 0;
  for (size_t i = 0; i < corners_.size(); ++i) {
    count += size_t(__builtin_popcountll(view->facing[i]));
    if (view->facing[i] != 0) __builtin_prefetch(table_.codes(component_.cells[i].brick, camera));
  }
  view->candidates.resize(count);
  SurfaceView::Candidate* next = view->candidates.data();
  for (size_t i = 0; i < corners_.size(); ++i) {
    if (view->facing[i] == 0) continue;
    const uint32_t brick = component_.cells[i].brick;
    const float depth = depthOf(viewpoint, i);
    const uint8_t* codes = table_.codes(brick, camera);
    const PixelWindow* end = table_.windowsEnd(brick, camera);
    for (const PixelWindow* w = table_.windowsBegin(brick, camera); w != end; ++w)
      for (uint64_t left = w->voxels & view->facing[i]; left != 0; left &= left - 1) {
        const int bit = __builtin_ctzll(left);
        *next++ = {uint32_t(64 * i) + uint32_t(bit), uint16_t(w->x + (codes[bit] & 15)),
                   uint16_t(w->y + (codes[bit] >> 4)), depth + viewpoint.depth_in_brick[bit]};
      }
  }
  // A face may be turned to a camera and lie outside its image.
  view->candidates.resize(size_t(next - view->candidates.data()));
}

void SurfaceVisibility::fillDepths(const Viewpoint& viewpoint, const cv::Mat& image,
                                   SurfaceView* view) const {
  float nearest = kFar;
  for (const SurfaceView::Candidate& c : view->candidates) nearest = std::min(nearest, c.depth);
  const double pitch = table_.lattice().pitch;
  const double voxel_px = viewpoint.focal * pitch / std::max(double(nearest), pitch);
  const uint32_t cell_px = uint32_t(std::max(1, int(std::ceil(kCell * voxel_px))));
  const uint32_t columns = uint32_t(image.cols) / cell_px + 1;
  const uint32_t rows = uint32_t(image.rows) / cell_px + 1;
  view->depths.assign(size_t(columns) * size_t(rows), kFar);
  view->places.resize(view->candidates.size());
  const size_t pixel_bytes = image.elemSize();
  // Division of 16 bit numbers by multiplication.
  const uint64_t inverse = (uint64_t(1) << 32) / cell_px + 1;
  for (size_t i = 0; i < view->candidates.size(); ++i) {
    const SurfaceView::Candidate& c = view->candidates[i];
    const uint32_t place = uint32_t(c.y * inverse >> 32) * columns + uint32_t(c.x * inverse >> 32);
    view->places[i] = place;
    __builtin_prefetch(image.data + c.y * image.step[0] + c.x * pixel_bytes);
    view->depths[place] = std::min(view->depths[place], c.depth);
  }
}

void SurfaceVisibility::findVisible(size_t camera, const cv::Mat& image, SurfaceView* view) const {
  findFacing(camera, view);
  findCandidates(camera, view);
  fillDepths(viewpoints_[camera], image, view);
  color(image, view);
}

void SurfaceVisibility::findAll(size_t camera, const cv::Mat& image, SurfaceView* view) const {
  view->facing.clear();
  for (const BrickVoxels& cell : component_.cells) view->facing.push_back(cell.voxels);
  findCandidates(camera, view);
  view->places.assign(view->candidates.size(), 0);
  view->depths.assign(1, kFar);
  color(image, view);
}

void SurfaceVisibility::color(const cv::Mat& image, SurfaceView* view) const {
  if (image.channels() == 3)
    colorVisible<3>(image, view);
  else
    colorVisible<1>(image, view);
}

template <int kChannels>
void SurfaceVisibility::colorVisible(const cv::Mat& image, SurfaceView* view) const {
  view->seen.assign(corners_.size(), 0);
  view->rgb.resize(corners_.size() * 64);
  const float behind = float(kBehind * table_.lattice().pitch);
  for (size_t i = 0; i < view->candidates.size(); ++i) {
    const SurfaceView::Candidate& c = view->candidates[i];
    if (c.depth > view->depths[view->places[i]] + behind) continue;
    view->seen[c.slot / 64] |= uint64_t(1) << c.slot % 64;
    const uint8_t* bgr = image.data + c.y * image.step[0] + size_t(c.x) * kChannels;
    view->rgb[c.slot] = {bgr[kChannels - 1], bgr[kChannels / 2], bgr[0]};
  }
}

}  // namespace markerless_mocap
