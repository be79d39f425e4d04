#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace markerless_mocap {

/// A brick is 4 x 4 x 4 voxels in a 64-bit word, bit x + 4 * y + 16 * z.
constexpr int kBrickSide = 4;
constexpr uint64_t kAllVoxels = ~uint64_t(0);

/// Box of voxels: low is inclusive, high exclusive.
struct VoxelBox {
  Eigen::Vector3i low = Eigen::Vector3i::Zero(), high = Eigen::Vector3i::Zero();

  bool contains(const Eigen::Vector3i& first, const Eigen::Vector3i& end) const {
    return (low.array() <= first.array()).all() && (high.array() >= end.array()).all();
  }
  bool meets(const Eigen::Vector3i& first, const Eigen::Vector3i& end) const {
    return (low.array() < end.array()).all() && (high.array() > first.array()).all();
  }
};

namespace brick_words {

constexpr uint64_t kLowFace[3] = {0x1111111111111111u, 0x000f000f000f000fu, 0x000000000000ffffu};
constexpr uint64_t kHighFace[3] = {kLowFace[0] << 3, kLowFace[1] << 12, kLowFace[2] << 48};
constexpr int kStep[3] = {1, 4, 16};

/// The voxels whose coordinate `axis` is from `begin` to `end` - 1, clamped to the brick.
inline uint64_t slab(int axis, int begin, int end) {
  uint64_t word = 0;
  for (int i = begin > 0 ? begin : 0; i < (end < kBrickSide ? end : kBrickSide); ++i)
    word |= kLowFace[axis] << (i * kStep[axis]);
  return word;
}

/// The voxels inside the box, of the brick whose first voxel is `corner`.
inline uint64_t inside(const VoxelBox& box, const Eigen::Vector3i& corner) {
  if (box.contains(corner, (corner.array() + kBrickSide).matrix())) return kAllVoxels;
  const Eigen::Vector3i low = box.low - corner, high = box.high - corner;
  return slab(0, low[0], high[0]) & slab(1, low[1], high[1]) & slab(2, low[2], high[2]);
}

/// Shifts by one voxel along the axis; voxels shifted out of the brick are dropped.
inline uint64_t up(uint64_t word, int axis) {
  return (word & ~kHighFace[axis]) << kStep[axis];
}
inline uint64_t down(uint64_t word, int axis) {
  return (word & ~kLowFace[axis]) >> kStep[axis];
}

/// The word and its 26-neighbours within the brick.
inline uint64_t grown(uint64_t word) {
  for (int axis = 0; axis < 3; ++axis) word |= up(word, axis) | down(word, axis);
  return word;
}

/// The 26-neighbours of the word's voxels in the brick at offset `step`, whose coordinates are -1,
/// 0 or 1.
inline uint64_t touched(uint64_t word, const int (&step)[3]) {
  for (int axis = 0; axis < 3; ++axis) {
    const int to_other_face = (kBrickSide - 1) * kStep[axis];
    if (step[axis] > 0)
      word = (word & kHighFace[axis]) >> to_other_face;
    else if (step[axis] < 0)
      word = (word & kLowFace[axis]) << to_other_face;
    else
      word |= up(word, axis) | down(word, axis);
  }
  return word;
}

/// The voxels of `word` that are 26-connected to its first one.
inline uint64_t firstComponent(uint64_t word) {
  uint64_t component = word & (~word + 1), before = 0;
  while (component != before) {
    before = component;
    component = grown(component) & word;
  }
  return component;
}

}  // namespace brick_words
}  // namespace markerless_mocap
