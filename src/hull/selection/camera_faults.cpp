#include "hull/selection/camera_faults.h"

#include <algorithm>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

/// An empty mask is wrong if its camera sees at least this fraction of the person.
constexpr double kSeesPerson = 0.05;
/// If more of the foreground than this is unexplained, each camera is tested.
constexpr double kMaxUnexplained = 0.3;
/// A wrong mask leaves the silhouettes of all other cameras unexplained, so a few cameras suffice.
constexpr int kQuickTestCameras = 3;
/// A camera is faulty if without it the unexplained fraction falls below kBlameRatio of its value,
/// and is smaller by kBlameMargin than without any other camera.
constexpr double kBlameRatio = 0.5;
constexpr double kBlameMargin = 0.1;
/// A brick with at least this many of its 64 voxels covers all its tiles, any other brick those of
/// its voxels.
constexpr int kReachesAll = 48;

int columnsOf(const Camera& camera) {
  return (camera.width() + 7) / 8;
}

template <class Visit>
void forEachTile(const TileBox& box, int columns, Visit visit) {
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) visit(size_t(y) * size_t(columns) + size_t(x));
}

double fractionSeen(const VoxelComponent& component, const ProjectionTable& table, size_t camera) {
  size_t seen = 0;
  for (const BrickVoxels& cell : component.cells)
    seen += size_t(__builtin_popcountll(cell.voxels & table.seen(cell.brick, camera)));
  return double(seen) / double(component.voxels);
}

}  // namespace

FaultyCameraFinder::FaultyCameraFinder(const CameraRig& rig, int min_views, VoxelVoting* voting)
    : rig_(rig), min_views_(min_views), voting_(voting) {
  const ProjectionTable& table = voting->table();
  const BlockLevel& bricks = table.level(0);
  for (size_t c = 0; c < rig.size(); ++c) {
    const int columns = columnsOf(rig[c]);
    looks_in_.emplace_back(size_t(columns) * size_t((rig[c].height() + 7) / 8), uint8_t(0));
    for (size_t brick = 0; brick < bricks.sees_some.size(); ++brick)
      if (__builtin_popcount(bricks.sees_some[brick]) >= min_views)
        forEachTile(bricks.tiles[brick * rig.size() + c], columns,
                    [&](size_t tile) { looks_in_[c][tile] = 1; });
  }
}

bool FaultyCameraFinder::mayLeaveOut(CameraSet cameras, CameraSet present) const {
  const int left_out = __builtin_popcount(cameras), all = __builtin_popcount(present);
  return 2 * left_out < all && all - left_out >= min_views_;
}

void FaultyCameraFinder::leaveOut(CameraSet cameras, const std::string& reason,
                                  Result* result) const {
  result->voters &= ~cameras;
  for (size_t c = 0; c < rig_.size(); ++c)
    if (cameras >> c & 1) result->faults.push_back({c, reason});
}

FaultyCameraFinder::Result FaultyCameraFinder::carve(const MaskSummary& masks,
                                                     const VoxelBox& window) {
  Result result;
  result.voters = masks.present;
  if (masks.full != 0 && mayLeaveOut(masks.full, masks.present))
    leaveOut(masks.full, "its mask is full", &result);
  result.components = voting_->carve(result.voters & ~masks.empty, window);
  if (masks.empty != 0) leaveOutEmpty(masks, window, &result);
  leaveOutContradicted(masks, window, &result);
  return result;
}

void FaultyCameraFinder::leaveOutEmpty(const MaskSummary& masks, const VoxelBox& window,
                                       Result* result) {
  const CameraSet gone = masks.present & ~result->voters;
  CameraSet wrong = 0;
  if (!result->components.empty())
    for (size_t c = 0; c < rig_.size(); ++c)
      if (masks.empty >> c & 1 &&
          fractionSeen(result->components[0], voting_->table(), c) >= kSeesPerson)
        wrong |= 1u << c;
  if (mayLeaveOut(wrong | gone, masks.present))
    leaveOut(wrong, "its mask is empty, but other cameras see a person in its view", result);
  if ((result->voters & masks.empty) != 0)
    result->components = voting_->carve(result->voters, window);
}

void FaultyCameraFinder::leaveOutContradicted(const MaskSummary& masks, const VoxelBox& window,
                                              Result* result) {
  // The rough test overestimates what is unexplained. If its result is small, the exact one is not
  // needed.
  for (const Reach how : {Reach::kRoughly, Reach::kExactly})
    if (unexplained(result->components, result->voters, kQuickTestCameras, how) < kMaxUnexplained)
      return;
  const int all = int(rig_.size());
  const double with_all = unexplained(result->components, result->voters, all, Reach::kExactly);
  const CameraSet gone = masks.present & ~result->voters;
  double min_fraction = 1, second = 1;
  CameraSet suspect = 0;
  std::vector<VoxelComponent> without_suspect;
  for (size_t c = 0; c < rig_.size(); ++c) {
    const CameraSet one = 1u << c;
    if ((result->voters & one) == 0 || !mayLeaveOut(gone | one, masks.present)) continue;
    std::vector<VoxelComponent> components = voting_->carve(result->voters & ~one, window);
    const double fraction = unexplained(components, result->voters & ~one, all, Reach::kExactly);
    second = std::min(second, std::max(fraction, min_fraction));
    if (fraction >= min_fraction) continue;
    min_fraction = fraction;
    suspect = one;
    without_suspect = std::move(components);
  }
  if (min_fraction > kBlameRatio * with_all || second - min_fraction < kBlameMargin) return;
  leaveOut(suspect, "its mask lacks a person on whom the other cameras agree", result);
  result->components = std::move(without_suspect);
}

double FaultyCameraFinder::unexplained(const std::vector<VoxelComponent>& components,
                                       CameraSet voters, int max_cameras, Reach how) {
  std::vector<size_t> cameras;
  for (size_t c = 0; c < rig_.size(); ++c)
    if (voters >> c & 1) cameras.push_back(c);
  if (cameras.empty()) return 0;
  // The cameras with the largest silhouettes are used, so that their order in the rig does not
  // matter.
  std::stable_sort(cameras.begin(), cameras.end(), [&](size_t a, size_t b) {
    return voting_->mask(a).setPixels() > voting_->mask(b).setPixels();
  });
  cameras.resize(std::min(cameras.size(), size_t(max_cameras)));
  std::vector<double> fractions;
  for (const size_t c : cameras) fractions.push_back(unexplainedIn(c, components, how));
  return medianAmong(fractions);
}

double FaultyCameraFinder::unexplainedIn(size_t camera,
                                         const std::vector<VoxelComponent>& components, Reach how) {
  const int columns = columnsOf(rig_[camera]), rows = int(looks_in_[camera].size()) / columns;
  reached_.assign(looks_in_[camera].size(), 0);
  for (const VoxelComponent& component : components)
    for (const BrickVoxels& cell : component.cells)
      how == Reach::kRoughly ? reachRoughly(camera, cell) : reach(camera, cell);
  const TileMask& mask = voting_->mask(camera);
  size_t set = 0, left = 0;
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < rows; ++y) {
      const size_t tile = size_t(y) * size_t(columns) + size_t(x);
      const bool counts = mask.tile(x, y) != 0 && looks_in_[camera][tile] != 0;
      set += counts;
      left += counts && reached_[tile] == 0;
    }
  return set == 0 ? 0 : double(left) / double(set);
}

void FaultyCameraFinder::reachRoughly(size_t camera, const BrickVoxels& cell) {
  const TileBox& brick = voting_->table().level(0).tiles[cell.brick * rig_.size() + camera];
  if (__builtin_popcountll(cell.voxels) < kReachesAll && brick.count() != 1) return;
  forEachTile(brick, columnsOf(rig_[camera]), [&](size_t tile) { reached_[tile] = 1; });
}

void FaultyCameraFinder::reach(size_t camera, const BrickVoxels& cell) {
  const ProjectionTable& table = voting_->table();
  const int columns = columnsOf(rig_[camera]), rows = int(reached_.size()) / columns;
  const TileBox& brick = table.level(0).tiles[cell.brick * rig_.size() + camera];
  if (__builtin_popcountll(cell.voxels) >= kReachesAll) {
    forEachTile(brick, columns, [&](size_t tile) { reached_[tile] = 1; });
    return;
  }
  // Half the distance to the next voxel, if that is more than a tile.
  const int half =
      brick.x1 == 0 ? 0 : std::max(brick.x1 - brick.x0, brick.y1 - brick.y0) / kBrickSide / 2;
  const uint8_t* codes = table.codes(cell.brick, camera);
  const PixelWindow* end = table.windowsEnd(cell.brick, camera);
  for (const PixelWindow* w = table.windowsBegin(cell.brick, camera); w != end; ++w)
    for (uint64_t bits = w->voxels & cell.voxels; bits != 0; bits &= bits - 1) {
      const uint8_t code = codes[__builtin_ctzll(bits)];
      const int x = (w->x + (code & 15)) / 8, y = (w->y + (code >> 4)) / 8;
      for (int v = std::max(0, y - half); v <= std::min(rows - 1, y + half); ++v)
        for (int u = std::max(0, x - half); u <= std::min(columns - 1, x + half); ++u)
          reached_[size_t(v) * size_t(columns) + size_t(u)] = 1;
    }
}

}  // namespace markerless_mocap
