#include "skeleton/cavity_filling.h"

namespace markerless_mocap {
namespace {

/// All bits from the lowest set one up.
uint64_t smearedUp(uint64_t word) {
  return word == 0 ? 0 : ~uint64_t(0) << __builtin_ctzll(word);
}
/// All bits from the highest set one down.
uint64_t smearedDown(uint64_t word) {
  return word == 0 ? 0 : ~uint64_t(0) >> __builtin_clzll(word);
}

/// What lies between two of the object's voxels of its own row.
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

/// Narrows `flanked` to what has the object before and behind it along an axis. `lines` blocks of
/// `length` steps of `stride` words, `width` words side by side.
void flankAlong(size_t begin, size_t lines, size_t line_stride, size_t length, size_t stride,
                size_t width, const BitWords& voxels, BitWords* before, BitWords* flanked) {
  for (size_t line = 0; line < lines; ++line) {
    const size_t start = begin + line * line_stride;
    before->assign(width, 0);
    for (size_t step = 0; step < length; ++step) {
      for (size_t w = 0; w < width; ++w) {
        (*flanked)[start + step * stride + w] &= (*before)[w];
        (*before)[w] |= voxels[start + step * stride + w];
      }
    }
    before->assign(width, 0);
    for (size_t step = length; step-- > 0;) {
      for (size_t w = 0; w < width; ++w) {
        (*flanked)[start + step * stride + w] &= (*before)[w];
        (*before)[w] |= voxels[start + step * stride + w];
      }
    }
  }
}

}  // namespace

void CavityFiller::markFlanked(const BitBox& box, const BitWords& voxels) {
  flanked_.assign(box.words, 0);
  flankAlongRows(box, voxels, &flanked_);
  const auto rows = size_t(box.ny + 2), planes = size_t(box.nz + 2);
  flankAlong(box.guard, planes, box.plane, rows, box.row, box.row, voxels, &before_, &flanked_);
  flankAlong(box.guard, 1, 0, planes, box.plane, box.plane, voxels, &before_, &flanked_);
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
