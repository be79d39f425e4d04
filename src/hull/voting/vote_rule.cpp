#include "hull/voting/vote_rule.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "hull/voting/bit_sliced_counter.h"
#include "hull/voting/brick_mask_lookup.h"

namespace markerless_mocap {
namespace {

/// Population count without the processor's instruction, which not every processor has.
int countOf(CameraSet set) {
  set -= set >> 1 & 0x55555555u;
  set = (set & 0x33333333u) + (set >> 2 & 0x33333333u);
  return int(((set + (set >> 4)) & 0x0f0f0f0fu) * 0x01010101u >> 24);
}

class Octree {
 public:
  Octree(const ProjectionTable& table, const VoteRule& rule, BrickVolume* volume)
      : table_(table), rule_(rule), volume_(volume) {
    const VoxelBox all{Eigen::Vector3i::Zero(), table.lattice().size};
    window_ = {rule.window.low.cwiseMax(all.low), rule.window.high.cwiseMin(all.high)};
    for (size_t c = 0; c < rule.masks.size(); ++c) {
      if (rule.masks[c] == nullptr) continue;
      voters_ |= 1u << c;
      order_.push_back(uint8_t(c));
    }
    // Small silhouettes first: they decide the most blocks.
    std::stable_sort(order_.begin(), order_.end(), [&](uint8_t a, uint8_t b) {
      return rule.masks[a]->setPixels() < rule.masks[b]->setPixels();
    });
  }

  void vote() const {
    const Eigen::Vector3i& size = table_.level(kTop).size;
    tbb::parallel_for(0, size.prod(), [&](int i) {
      decide(kTop, {i % size.x(), i / size.x() % size.y(), i / (size.x() * size.y())}, voters_, 0);
    });
  }

 private:
  static constexpr int kTop = ProjectionTable::kLevels - 1;

  /// \param open cameras that have not decided on a block around this one
  /// \param against weight of those that have decided against it
  void decide(int level_index, const Eigen::Vector3i& at, CameraSet open, uint32_t against) const {
    const int side = kBrickSide << level_index;
    if (!window_.meets(at * side, (at.array() + 1).matrix() * side)) return;
    const BlockLevel& level = table_.level(level_index);
    const size_t block = level.blockAt(at.x(), at.y(), at.z());
    const CameraSet some = level.sees_some[block] & voters_;
    if (countOf(some) < rule_.min_views) return;
    open &= some;
    if (!castBlockVotes(level, block, &open, &against)) return;
    const bool views_known = countOf(level.sees_all[block] & voters_) >= rule_.min_views;
    if (open == 0 && views_known)
      fill(at, level_index);
    else if (level_index == 0)
      decideBrick(at, block, open, against, views_known);
    else
      descend(level_index - 1, at, open, against);
  }

  /// Lets the open cameras vote on a block as a whole, and removes those that decide from `open`.
  /// Returns false if no voxel of the block is foreground.
  bool castBlockVotes(const BlockLevel& level, size_t block, CameraSet* open,
                      uint32_t* against) const {
    const TileBox* tiles = &level.tiles[block * table_.cameras()];
    for (const uint8_t c : order_) {
      const CameraSet bit = 1u << c;
      if ((*open & bit) == 0) continue;
      const TileCount count = rule_.masks[c]->count(tiles[c]);
      if (count.any == 0 && (level.sees_all[block] & bit) != 0) {
        *against += rule_.weights[c];
        if (*against >= rule_.limit) return false;
        *open &= ~bit;
      } else if (count.all == tiles[c].count()) {
        *open &= ~bit;
      }
    }
    return true;
  }

  void decideBrick(const Eigen::Vector3i& at, size_t brick, CameraSet open, uint32_t against,
                   bool views_known) const {
    uint64_t word = brick_words::inside(window_, at * kBrickSide);
    word &= rule_.limit - against == 1 ? withoutVoteAgainst(brick, open, word)
                                       : belowVoteLimit(brick, open, against);
    if (word == 0) return;
    if (!views_known) {
      BitSlicedCounter views(0);
      for (const uint8_t c : order_) views.add(table_.seen(brick, c), 1);
      word &= views.atLeast(uint32_t(rule_.min_views));
    }
    volume_->set(at.x(), at.y(), at.z(), word);
  }

  uint64_t withoutVoteAgainst(size_t brick, CameraSet open, uint64_t word) const {
    // Loading from memory takes longer than the test of one camera.
    for (const uint8_t c : order_)
      if (open >> c & 1) __builtin_prefetch(table_.codes(brick, c));
    for (const uint8_t c : order_) {
      if ((open >> c & 1) == 0 || rule_.weights[c] == 0) continue;
      word &= ~votesAgainst(brick, c);
      if (word == 0) break;
    }
    return word;
  }

  uint64_t belowVoteLimit(size_t brick, CameraSet open, uint32_t against) const {
    BitSlicedCounter counter(against);
    for (const uint8_t c : order_)
      if (open >> c & 1) counter.add(votesAgainst(brick, c), rule_.weights[c]);
    return ~counter.atLeast(rule_.limit);
  }

  /// The voxels that the camera sees outside its silhouette.
  uint64_t votesAgainst(size_t brick, size_t camera) const {
    const uint64_t set = setInBrick(table_, *rule_.masks[camera], brick, camera);
    const bool sees_all = table_.level(0).sees_all[brick] >> camera & 1;
    return (sees_all ? kAllVoxels : table_.seen(brick, camera)) & ~set;
  }

  void descend(int level_index, const Eigen::Vector3i& at, CameraSet open, uint32_t against) const {
    const Eigen::Vector3i& size = table_.level(level_index).size;
    const Eigen::Vector3i low = 2 * at, high = (low.array() + 2).min(size.array());
    const BlockLevel& level = table_.level(level_index);
    const size_t pair = 2 * table_.cameras(), per_line = 64 / sizeof(TileBox);
    for (int z = low.z(); z < high.z(); ++z)
      for (int y = low.y(); y < high.y(); ++y) {
        const TileBox* tiles = &level.tiles[level.blockAt(low.x(), y, z) * table_.cameras()];
        for (size_t i = 0; i < pair; i += per_line) __builtin_prefetch(tiles + i);
      }
    for (int z = low.z(); z < high.z(); ++z)
      for (int y = low.y(); y < high.y(); ++y)
        for (int x = low.x(); x < high.x(); ++x) decide(level_index, {x, y, z}, open, against);
  }

  void fill(const Eigen::Vector3i& at, int level_index) const {
    const Eigen::Vector3i low = at * (1 << level_index);
    const Eigen::Vector3i high = (low.array() + (1 << level_index)).min(volume_->size().array());
    for (int z = low.z(); z < high.z(); ++z)
      for (int y = low.y(); y < high.y(); ++y)
        for (int x = low.x(); x < high.x(); ++x) {
          const uint64_t word = brick_words::inside(window_, kBrickSide * Eigen::Vector3i(x, y, z));
          if (word != 0) volume_->set(x, y, z, word);
        }
  }

  const ProjectionTable& table_;
  const VoteRule& rule_;
  BrickVolume* volume_;
  VoxelBox window_;
  CameraSet voters_ = 0;
  std::vector<uint8_t> order_;
};

}  // namespace

void vote(const ProjectionTable& table, const VoteRule& rule, BrickVolume* volume) {
  volume->clear();
  Octree(table, rule, volume).vote();
}

}  // namespace markerless_mocap
