#include "skeleton/thinning/cavity_filling.h"

namespace markerless_mocap {
namespace {

/// All bits from the lowest set bit upwards.
uint64_t smearedUp(uint64_t word) {
  return word == 0 ? 0 : ~uint64_t(0) << __builtin_ctzll(word);
}
/// All bits from the highest set bit downwards.
uint64_t smearedDown(uint64_t word) {
  return word == 0 ? 0 : ~uint64_t(0) >> __builtin_clzll(word);
}

/// Sets the empty voxels between two of the object's voxels of the same row.
void flankAlongRows(const BitBox& box, const BitWords& voxels, BitWords* flanked) {
  for (size_t row = box.guard; row < box.words - box.guard; row += box.row) {
    uint64_t whole = 0;
    for (size_t w = row; w < row + box.row; ++w) {
      (*flanked)[w] = whole | smearedUp(voxels[w]);
      if (voxels[w] != 0) whole = ~uint64_t(0);
    }
    whole = 0;
    for (size_t w = row + box.row; w-- > row;) {
      (*flanked)[w] &= ~voxels[w] & (whole | smearedDown(voxels[w]));
      if (voxels[w] != 0) whole = ~uint64_t(0);
    }
  }
}

/// Restricts `flanked` to voxels with the object on both sides across the rows of a plane.
void flankAcrossRows(const BitBox& box, const BitWords& voxels, BitWords* flanked) {
  for (size_t plane = box.guard; plane < box.words - box.guard; plane += box.plane) {
    for (size_t first = plane; first < plane + box.row; ++first) {
      uint64_t before = 0;
      for (size_t w = first; w < plane + box.plane; w += box.row) {
        (*flanked)[w] &= before;
        before |= voxels[w];
      }
      uint64_t behind = 0;
      for (size_t w = first + box.plane; w > first;) {
        w -= box.row;
        (*flanked)[w] &= behind;
        behind |= voxels[w];
      }
    }
  }
}

void flankByPlane(size_t plane, size_t words, const BitWords& voxels, uint64_t* before,
                  BitWords* flanked) {
  for (size_t w = 0; w < words; ++w) {
    (*flanked)[plane + w] &= before[w];
    before[w] |= voxels[plane + w];
  }
}

/// The same across planes; `before` is scratch memory.
void flankAcrossPlanes(const BitBox& box, const BitWords& voxels, BitWords* before,
                       BitWords* flanked) {
  before->assign(box.plane, 0);
  for (size_t plane = box.guard; plane < box.words - box.guard; plane += box.plane)
    flankByPlane(plane, box.plane, voxels, before->data(), flanked);
  before->assign(box.plane, 0);
  for (size_t plane = box.words - box.guard; plane > box.guard;) {
    plane -= box.plane;
    flankByPlane(plane, box.plane, voxels, before->data(), flanked);
  }
}

}  // namespace

void CavityFiller::markFlanked(const BitBox& box, const BitWords& voxels) {
  flanked_.assign(box.words, 0);
  flankAlongRows(box, voxels, &flanked_);
  flankAcrossRows(box, voxels, &flanked_);
  flankAcrossPlanes(box, voxels, &before_, &flanked_);
}

void CavityFiller::openFromOutside(const BitBox& box, const BitWords& voxels) {
  const size_t steps[3] = {1, box.row * 64, box.plane * 64};
  open_.clear();
  forEachBit(box, flanked_, [&](size_t bit) {
    for (size_t step : steps) {
      for (size_t other : {bit - step, bit + step}) {
        if (testBit(voxels, other) || testBit(flanked_, other)) continue;
        open_.push_back(bit);
        return;
      }
    }
  });
  for (size_t bit : open_) clearBit(&flanked_, bit);
  while (!open_.empty()) {
    const size_t bit = open_.back();
    open_.pop_back();
    for (size_t step : steps) {
      for (size_t other : {bit - step, bit + step}) {
        if (!testBit(flanked_, other)) continue;
        clearBit(&flanked_, other);
        open_.push_back(other);
      }
    }
  }
}

uint32_t CavityFiller::fill(const BitBox& box, BitWords* voxels) {
  markFlanked(box, *voxels);
  openFromOutside(box, *voxels);
  uint32_t filled = 0;
  for (size_t w = box.guard; w < box.words - box.guard; ++w) {
    filled += uint32_t(__builtin_popcountll(flanked_[w]));
    (*voxels)[w] |= flanked_[w];
  }
  return filled;
}

}  // namespace markerless_mocap
