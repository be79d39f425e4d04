#include <algorithm>

#include "numerics/simd_clones.h"
#include "skeleton/thinning/simple_point.h"
#include "skeleton/thinning/thinning_scheme.h"

namespace markerless_mocap {
namespace {

/// Finds the border: voxels that are not kept and have an empty one among their 6 nearest
/// neighbours.
MOCAP_WIDEST void findBorder(ptrdiff_t y, ptrdiff_t z, const uint64_t* __restrict object,
                             const uint64_t* __restrict kept, size_t begin, size_t end,
                             uint64_t* __restrict border) {
  for (size_t i = begin; i < end; ++i) {
    const uint64_t* o = object + i;
    const uint64_t along_x = (o[0] >> 1 | o[1] << 63) & (o[0] << 1 | o[-1] >> 63);
    border[i] = o[0] & ~kept[i] & ~(along_x & o[y] & o[-y] & o[z] & o[-z]);
  }
}

bool isEnd(uint32_t around) {
  return (around & (around - 1)) == 0;
}

}  // namespace

void SymmetricThinning::begin(const BitBox& box, int persistence, const BitWords& object) {
  cliques_.resize(box);
  for (BitWords* words : {&border_, &candidates_, &kept_, &isthmuses_, &seen_})
    words->assign(box.words, 0);
  new_isthmuses_.assign(size_t(persistence), {});
  candidate_words_ = object_words_ = WordSet(box.words);
  size_t voxels = 0;
  for (size_t i = 0; i < box.words; ++i) {
    if (object[i] == 0) continue;
    object_words_.add(i);
    voxels += size_t(__builtin_popcountll(object[i]));
  }
  border_voxels_.resize(voxels);
}

void SymmetricThinning::listBorder(const BitBox& box, const BitWords& object) {
  BorderVoxel* voxel = border_voxels_.data();
  candidate_words_.clear();
  object_words_.list(&object_spans_);
  for (const auto& [begin, end] : object_spans_) {
    findBorder(ptrdiff_t(box.row), ptrdiff_t(box.plane), object.data(), kept_.data(), begin, end,
               border_.data());
    for (size_t i = begin; i < end; ++i) {
      if (border_[i] == 0) continue;
      candidate_words_.add(i);
      for (uint64_t left = border_[i]; left != 0; left &= left - 1, ++voxel) {
        voxel->bit = uint32_t(i * 64) + uint32_t(__builtin_ctzll(left));
        voxel->around = neighborhood(box, object.data(), voxel->bit) & ~kCenterBit;
      }
    }
  }
  border_count_ = size_t(voxel - border_voxels_.data());
}

void SymmetricThinning::classifyBorder() {
  const SimplePointTable& simple = SimplePointTable::shared();
  size_t hard = 0;
  for (size_t n = 0; n < border_count_; ++n) {
    const BorderVoxel voxel = border_voxels_[n];
    const bool removable = simple(voxel.around);
    candidates_[voxel.bit / 64] |= uint64_t(removable) << (voxel.bit % 64);
    border_voxels_[hard] = voxel;  // voxels that are not simple are moved to the front
    hard += removable ? 0 : 1;
  }
  for (size_t n = 0; n < hard; ++n)
    if (objectComponents(border_voxels_[n].around) > 1) setBit(&isthmuses_, border_voxels_[n].bit);
}

void SymmetricThinning::keepEnds() {
  size_t others = 0;
  for (size_t n = 0; n < border_count_; ++n) {
    const BorderVoxel voxel = border_voxels_[n];
    border_voxels_[others] = voxel;
    if (isEnd(voxel.around)) {
      setBit(&kept_, voxel.bit);
    } else {
      ++others;
    }
  }
  border_count_ = others;
}

bool SymmetricThinning::finishRound(BitWords* object) {
  uint64_t removed = 0;
  std::rotate(new_isthmuses_.begin(), new_isthmuses_.end() - 1, new_isthmuses_.end());
  new_isthmuses_.front().clear();
  candidate_words_.list(&candidate_spans_);
  for (const auto& [begin, end] : candidate_spans_) {
    for (size_t i = begin; i < end; ++i) {
      removed |= candidates_[i];
      (*object)[i] &= ~candidates_[i];
      candidates_[i] = 0;
      if ((*object)[i] == 0) object_words_.remove(i);
      if (isthmuses_[i] == 0) continue;
      if (const uint64_t fresh = isthmuses_[i] & ~seen_[i]; fresh != 0)
        new_isthmuses_.front().push_back({i, fresh});
      seen_[i] |= isthmuses_[i];
      isthmuses_[i] = 0;
    }
  }
  const bool waiting = std::any_of(new_isthmuses_.begin(), new_isthmuses_.end(),
                                   [](const auto& f) { return !f.empty(); });
  for (const Bits& old : new_isthmuses_.back()) kept_[old.word] |= old.bits & (*object)[old.word];
  return removed != 0 || waiting;
}

void SymmetricThinning::thin(const BitBox& box, int persistence, BitWords* object) {
  begin(box, persistence, *object);
  bool changed = true;
  for (int round = 0; changed; ++round) {
    listBorder(box, *object);
    if (round == 0) keepEnds();
    classifyBorder();
    cliques_.keep(candidate_words_, *object, &candidates_, &isthmuses_);
    changed = finishRound(object);
  }
}

}  // namespace markerless_mocap
