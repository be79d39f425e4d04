#include "hull/color/coloring.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace markerless_mocap {
namespace {

constexpr Rgb kGrey = {128, 128, 128};

int squaredDistance(const Rgb& a, const Rgb& b) {
  int sum = 0;
  for (int c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

/// 2^19 / count + 1, for up to 32 cameras.
constexpr std::array<uint32_t, 33> inverses() {
  std::array<uint32_t, 33> table{};
  for (uint32_t count = 1; count < table.size(); ++count) table[count] = (1u << 19) / count + 1;
  return table;
}
constexpr std::array<uint32_t, 33> kInverse = inverses();

/// Calls visit(slot) for the voxels of a cell.
template <class Visit>
void forEachSlot(uint64_t voxels, size_t cell, Visit visit) {
  for (; voxels != 0; voxels &= voxels - 1) visit(64 * cell + size_t(__builtin_ctzll(voxels)));
}

}  // namespace

VoxelColoring::VoxelColoring(const CameraRig& rig, const ProjectionTable& table,
                             double color_vote_distance, bool all_vote)
    : all_vote_(all_vote),
      // For an integer n and a real x, n < x is the same as n < ceil(x).
      limit_(int(std::ceil(color_vote_distance * color_vote_distance))),
      visibility_(rig, table),
      views_(rig.size()) {}

void VoxelColoring::ColorSum::add(const Rgb& color) {
  for (int c = 0; c < 3; ++c) rgb[c] = uint16_t(rgb[c] + color[c]);
  ++count;
}

Rgb VoxelColoring::ColorSum::mean() const {
  // Rounded division by multiplication: sums are below 2^13, counts below 2^6.
  const uint32_t inverse = kInverse[count];
  Rgb color;
  for (int c = 0; c < 3; ++c) color[c] = uint8_t((rgb[c] + count / 2u) * inverse >> 19);
  return color;
}

void VoxelColoring::sumColors(size_t cells) {
  sums_.assign(cells * 64, ColorSum());
  for (const SurfaceView& view : views_)
    for (size_t cell = 0; cell < view.seen.size(); ++cell)
      forEachSlot(view.seen[cell], cell, [&](size_t slot) { sums_[slot].add(view.rgb[slot]); });
}

void VoxelColoring::setColors(const std::vector<ComponentVoxel>& order,
                              std::vector<HullVoxel>* voxels) const {
  const auto passOn = [&](size_t from, size_t to) {
    const uint32_t a = order[from].index, b = order[to].index;
    return sums_[order[to].slot].count == 0 && (a > b ? a - b : b - a) == 1;
  };
  std::vector<bool> known(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const ColorSum& sum = sums_[order[i].slot];
    const bool before = sum.count == 0 && i > 0 && known[i - 1] && passOn(i - 1, i);
    known[i] = sum.count > 0 || before;
    (*voxels)[i].rgb = sum.count > 0 ? sum.mean() : before ? (*voxels)[i - 1].rgb : kGrey;
  }
  for (size_t i = order.size(); i-- > 1;)
    if (known[i] && !known[i - 1] && passOn(i, i - 1)) {
      known[i - 1] = true;
      (*voxels)[i - 1].rgb = (*voxels)[i].rgb;
    }
}

void VoxelColoring::addVotes(const SurfaceView& view, int axis) {
  using namespace brick_words;
  const int step = kStep[axis], far = (kBrickSide - 1) * step;
  for (size_t cell = 0; cell < view.seen.size(); ++cell) {
    const uint64_t seen = view.seen[cell];
    if (seen == 0) continue;
    const auto compare = [&](size_t slot, size_t other) {
      ColorVotes& of_voxel = votes_[slot];
      ++of_voxel.possible[axis];
      if (squaredDistance(view.rgb[slot], view.rgb[other]) < limit_) ++of_voxel.votes[axis];
    };
    forEachSlot(seen & down(seen, axis), cell,
                [&](size_t slot) { compare(slot, slot + size_t(step)); });
    const int after = visibility_.cellAfter(cell, axis);
    if (after < 0) continue;
    const uint64_t across = seen & (view.seen[size_t(after)] & kLowFace[axis]) << far;
    forEachSlot(across, cell,
                [&](size_t slot) { compare(slot, 64 * size_t(after) + slot % 64 - size_t(far)); });
  }
}

void VoxelColoring::findViews(const std::vector<cv::Mat>& images, bool hidden_too) {
  tbb::parallel_for(size_t(0), images.size(), [&](size_t c) {
    if (images[c].empty())
      views_[c].seen.clear();
    else if (hidden_too)
      visibility_.findAll(c, images[c], &views_[c]);
    else
      visibility_.findVisible(c, images[c], &views_[c]);
  });
}

void VoxelColoring::paint(const VoxelComponent& component, const std::vector<ComponentVoxel>& order,
                          const std::vector<cv::Mat>& images, std::vector<HullVoxel>* voxels) {
  visibility_.set(component);
  findViews(images, false);
  sumColors(component.cells.size());
  setColors(order, voxels);
  if (all_vote_) findViews(images, true);
  votes_.assign(component.cells.size() * 64, ColorVotes());
  for (const SurfaceView& view : views_)
    for (int axis = 0; axis < 3; ++axis) addVotes(view, axis);
  for (size_t i = 0; i < order.size(); ++i) (*voxels)[i].color_votes = votes_[order[i].slot];
}

}  // namespace markerless_mocap
