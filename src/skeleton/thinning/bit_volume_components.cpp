#include "skeleton/thinning/bit_volume_components.h"

namespace markerless_mocap {

uint32_t LargestComponent::root(uint32_t run) {
  while (runs_[run].parent != run) {
    runs_[run].parent = runs_[runs_[run].parent].parent;
    run = runs_[run].parent;
  }
  return run;
}

void LargestComponent::join(uint32_t a, uint32_t b) {
  a = root(a);
  b = root(b);
  if (a == b) return;
  if (b < a) std::swap(a, b);
  runs_[b].parent = a;
  runs_[a].voxels += runs_[b].voxels;
}

void LargestComponent::listRuns(const BitBox& box, const BitWords& voxels) {
  runs_.clear();
  first_run_.clear();
  const int rows = (box.ny + 2) * (box.nz + 2);
  for (int row = 0; row < rows; ++row) {
    const auto first = uint32_t(runs_.size());
    first_run_.push_back(first);
    for (size_t w = 0; w < box.row; ++w) {
      const int base = int(w) * 64;
      for (uint64_t left = voxels[box.guard + size_t(row) * box.row + w]; left != 0;) {
        const int begin = __builtin_ctzll(left);
        const uint64_t above = ~left & (~uint64_t(0) << begin);
        const int end = above == 0 ? 64 : __builtin_ctzll(above);
        left = above == 0 ? 0 : left & (~uint64_t(0) << end);
        const auto count = uint32_t(end - begin);
        if (runs_.size() > first && runs_.back().behind == base + begin) {
          runs_.back().behind += int(count);
          runs_.back().voxels += count;
        } else {
          runs_.push_back({row, base + begin, base + end, uint32_t(runs_.size()), count});
        }
      }
    }
  }
  first_run_.push_back(uint32_t(runs_.size()));
}

void LargestComponent::joinRows(int row, int earlier_row) {
  uint32_t a = first_run_[size_t(row)], b = first_run_[size_t(earlier_row)];
  const uint32_t a_end = first_run_[size_t(row) + 1], b_end = first_run_[size_t(earlier_row) + 1];
  while (a < a_end && b < b_end) {
    if (runs_[a].first <= runs_[b].behind && runs_[b].first <= runs_[a].behind) join(a, b);
    (runs_[a].behind < runs_[b].behind ? a : b) += 1;
  }
}

DroppedComponents LargestComponent::keep(const BitBox& box, BitWords* voxels) {
  listRuns(box, *voxels);
  const int across = box.ny + 2;
  for (int row = across + 1; row < across * (box.nz + 2); ++row) {
    if (first_run_[size_t(row)] == first_run_[size_t(row) + 1]) continue;
    for (int earlier : {row - 1, row - across - 1, row - across, row - across + 1})
      joinRows(row, earlier);
  }
  DroppedComponents dropped;
  uint32_t largest = 0;
  for (uint32_t run = 0; run < runs_.size(); ++run) {
    if (runs_[run].parent != run) continue;
    if (runs_[run].voxels > runs_[largest].voxels) largest = run;
    ++dropped.components;
  }
  if (dropped.components > 0) --dropped.components;
  if (dropped.components == 0) return dropped;
  for (uint32_t run = 0; run < runs_.size(); ++run) {
    if (root(run) == largest) continue;
    const size_t row = box.guard + size_t(runs_[run].row) * box.row;
    for (int bit = runs_[run].first; bit < runs_[run].behind; ++bit) {
      clearBit(voxels, row * 64 + size_t(bit));
      ++dropped.voxels;
    }
  }
  return dropped;
}

}  // namespace markerless_mocap
