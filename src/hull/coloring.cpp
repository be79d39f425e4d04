#include "hull/coloring.h"

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

/// Calls visit(slot) for the voxels of a cell.
template <class Visit>
void forEachSlot(uint64_t voxels, size_t cell, Visit visit) {
  for (; voxels != 0; voxels &= voxels - 1) visit(64 * cell + size_t(__builtin_ctzll(voxels)));
}

/// Sum of colours per slot.
struct ColorSum {
  uint16_t rgb[3] = {0, 0, 0};
  uint16_t count = 0;

  void add(const Rgb& color) {
    for (int c = 0; c < 3; ++c) rgb[c] = uint16_t(rgb[c] + color[c]);
    ++count;
  }
  Rgb mean() const {
    Rgb color;
    for (int c = 0; c < 3; ++c) color[c] = uint8_t((rgb[c] + count / 2) / count);
    return color;
  }
};

std::vector<ColorSum> sumColors(const std::vector<SurfaceView>& views, size_t cells) {
  std::vector<ColorSum> sums(cells * 64);
  for (const SurfaceView& view : views)
    for (size_t cell = 0; cell < view.seen.size(); ++cell)
      forEachSlot(view.seen[cell], cell, [&](size_t slot) { sums[slot].add(view.rgb[slot]); });
  return sums;
}

void setColors(const std::vector<ColorSum>& sums, const std::vector<PieceVoxel>& order,
               std::vector<HullVoxel>* voxels) {
  const auto passOn = [&](size_t from, size_t to) {
    const uint32_t a = order[from].index, b = order[to].index;
    return sums[order[to].slot].count == 0 && (a > b ? a - b : b - a) == 1;
  };
  std::vector<bool> known(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const ColorSum& sum = sums[order[i].slot];
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

/// Votes of one camera along one axis.
void addVotes(const SurfaceSight& sight, const SurfaceView& view, int axis, int limit,
              std::vector<ColorVotes>* votes) {
  using namespace leaf_words;
  const int step = kStep[axis], far = (kLeaf - 1) * step;
  for (size_t cell = 0; cell < view.seen.size(); ++cell) {
    const uint64_t seen = view.seen[cell];
    if (seen == 0) continue;
    const auto compare = [&](size_t slot, size_t other) {
      ColorVotes& of_voxel = (*votes)[slot];
      ++of_voxel.possible[axis];
      if (squaredDistance(view.rgb[slot], view.rgb[other]) < limit) ++of_voxel.votes[axis];
    };
    forEachSlot(seen & down(seen, axis), cell,
                [&](size_t slot) { compare(slot, slot + size_t(step)); });
    const int after = sight.cellAfter(cell, axis);
    if (after < 0) continue;
    const uint64_t across = seen & (view.seen[size_t(after)] & kLowest[axis]) << far;
    forEachSlot(across, cell,
                [&](size_t slot) { compare(slot, 64 * size_t(after) + slot % 64 - size_t(far)); });
  }
}

}  // namespace

void colorVoxels(SurfaceSight* sight, const Piece& piece, const std::vector<PieceVoxel>& order,
                 const std::vector<cv::Mat>& images, double color_vote_distance,
                 std::vector<HullVoxel>* voxels) {
  sight->set(piece);
  std::vector<SurfaceView> views(images.size());
  tbb::parallel_for(size_t(0), images.size(), [&](size_t c) {
    if (!images[c].empty()) views[c] = sight->look(c, images[c]);
  });
  setColors(sumColors(views, piece.cells.size()), order, voxels);

  std::vector<ColorVotes> votes(piece.cells.size() * 64);
  // Below the limit: an integer below a square that may have a fraction is below its ceiling.
  const int limit = int(std::ceil(color_vote_distance * color_vote_distance));
  for (const SurfaceView& view : views)
    for (int axis = 0; axis < 3; ++axis) addVotes(*sight, view, axis, limit, &votes);
  for (size_t i = 0; i < order.size(); ++i) (*voxels)[i].color_votes = votes[order[i].slot];
}

}  // namespace markerless_mocap
