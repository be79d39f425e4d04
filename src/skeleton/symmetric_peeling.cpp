#include <algorithm>

#include "skeleton/simple_point.h"
#include "skeleton/thinning_scheme.h"

namespace markerless_mocap {
namespace {

/// Voxels with one of the six nearest neighbours empty that are not kept.
__attribute__((target_clones("avx2", "default"))) void findBorder(ptrdiff_t y, ptrdiff_t z,
                                                                  const uint64_t* __restrict object,
                                                                  const uint64_t* __restrict kept,
                                                                  size_t begin, size_t end,
                                                                  uint64_t* __restrict border) {
  for (size_t i = begin; i < end; ++i) {
    const uint64_t* o = object + i;
    const uint64_t along_x = (o[0] >> 1 | o[1] << 63) & (o[0] << 1 | o[-1] >> 63);
    border[i] = o[0] & ~kept[i] & ~(along_x & o[y] & o[-y] & o[z] & o[-z]);
  }
}

}  // namespace

void SymmetricPeeling::resize(const BitBox& box) {
  cliques_ = CriticalCliques(box);
  border_.assign(box.words, 0);
  candidates_.assign(box.words, 0);
  kept_.assign(box.words, 0);
}

void SymmetricPeeling::listSpans(const BitBox& box, const BitWords& object) {
  rows_.assign(size_t(box.nz + 2), {box.ny + 2, -1});
  for (int z = 1; z <= box.nz; ++z) {
    auto& [first, last] = rows_[size_t(z)];
    for (int y = 1; y <= box.ny; ++y) {
      const auto row = object.begin() + ptrdiff_t(box.wordOf(y, z));
      if (std::all_of(row, row + ptrdiff_t(box.row), [](uint64_t word) { return word == 0; }))
        continue;
      first = std::min(first, y);
      last = y;
    }
  }
  next_spans_.clear();
  for (int z = 0; z <= box.nz; ++z) {
    const int first = std::min(rows_[size_t(z)].first, rows_[size_t(z) + 1].first) - 1;
    const int last = std::max(rows_[size_t(z)].second, rows_[size_t(z) + 1].second);
    if (last >= 0) next_spans_.emplace_back(box.wordOf(first, z), box.wordOf(last + 1, z));
  }
}

void SymmetricPeeling::judgeBorder(const BitBox& box, const BitWords& object) {
  const SimplePointTable& simple = SimplePointTable::shared();
  for (const auto& [begin, end] : spans_) {
    findBorder(ptrdiff_t(box.row), ptrdiff_t(box.plane), object.data(), kept_.data(), begin, end,
               border_.data());
    for (size_t i = begin; i < end; ++i) {
      uint64_t removable = 0, kept = 0;
      for (uint64_t left = border_[i]; left != 0; left &= left - 1) {
        const uint64_t bit = left & -left;
        const uint32_t around =
            neighborhood(box, object.data(), i * 64 + size_t(__builtin_ctzll(left))) & ~kCenterBit;
        if ((around & (around - 1)) == 0) {
          kept |= bit;
        } else if (simple(around)) {
          removable |= bit;
        } else if (objectComponents(around) > 1) {
          kept |= bit;
        }
      }
      candidates_[i] = removable;
      kept_[i] |= kept;
    }
  }
}

bool SymmetricPeeling::removeCandidates(BitWords* object) {
  uint64_t removed = 0;
  for (const auto& [begin, end] : spans_) {
    for (size_t i = begin; i < end; ++i) {
      (*object)[i] &= ~candidates_[i];
      removed |= candidates_[i];
    }
  }
  return removed != 0;
}

void SymmetricPeeling::peel(const BitBox& box, BitWords* object) {
  resize(box);
  listSpans(box, *object);
  spans_ = next_spans_;
  BitWords before;
  do {
    // Rows that a round has emptied are gone over once more, so that nothing of it is left there.
    listSpans(box, *object);
    before = kept_;
    judgeBorder(box, *object);
    cliques_.keep(spans_, *object, &candidates_, &kept_);
    spans_.swap(next_spans_);
  } while (removeCandidates(object) || kept_ != before);
}

}  // namespace markerless_mocap
