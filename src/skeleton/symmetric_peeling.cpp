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

bool isEnd(uint32_t around) {
  return (around & (around - 1)) == 0;
}

}  // namespace

void SymmetricPeeling::begin(const BitBox& box, int persistence, const BitWords& object) {
  cliques_.resize(box);
  for (BitWords* words : {&border_, &candidates_, &kept_, &isthmuses_, &seen_})
    words->assign(box.words, 0);
  fresh_.assign(size_t(persistence), {});
  candidate_words_ = object_words_ = WordSet(box.words);
  for (size_t i = 0; i < box.words; ++i)
    if (object[i] != 0) object_words_.add(i);
}

void SymmetricPeeling::listBorder(const BitBox& box, const BitWords& object) {
  border_voxels_.clear();
  surroundings_.clear();
  object_words_.list(&object_spans_);
  for (const auto& [begin, end] : object_spans_) {
    findBorder(ptrdiff_t(box.row), ptrdiff_t(box.plane), object.data(), kept_.data(), begin, end,
               border_.data());
    for (size_t i = begin; i < end; ++i) {
      for (uint64_t left = border_[i]; left != 0; left &= left - 1) {
        const size_t bit = i * 64 + size_t(__builtin_ctzll(left));
        border_voxels_.push_back(bit);
        surroundings_.push_back(neighborhood(box, object.data(), bit) & ~kCenterBit);
      }
    }
  }
}

void SymmetricPeeling::judgeBorder() {
  const SimplePointTable& simple = SimplePointTable::shared();
  not_simple_.resize(border_voxels_.size());
  size_t hard = 0;
  for (size_t n = 0; n < border_voxels_.size(); ++n) {
    const bool removable = simple(surroundings_[n]);
    candidates_[border_voxels_[n] / 64] |= uint64_t(removable) << (border_voxels_[n] % 64);
    not_simple_[hard] = n;
    hard += removable ? 0 : 1;
  }
  not_simple_.resize(hard);
  for (size_t n : not_simple_)
    if (objectComponents(surroundings_[n]) > 1) setBit(&isthmuses_, border_voxels_[n]);
}

void SymmetricPeeling::keepEnds() {
  for (size_t n = 0; n < border_voxels_.size(); ++n) {
    if (!isEnd(surroundings_[n])) continue;
    clearBit(&candidates_, border_voxels_[n]);
    setBit(&kept_, border_voxels_[n]);
  }
}

bool SymmetricPeeling::removeCandidates(BitWords* object) {
  uint64_t removed = 0;
  object_words_.clear();
  for (const auto& [begin, end] : object_spans_) {
    for (size_t i = begin; i < end; ++i) {
      removed |= candidates_[i];
      (*object)[i] &= ~candidates_[i];
      candidates_[i] = 0;
      if ((*object)[i] != 0) object_words_.add(i);
    }
  }
  return removed != 0;
}

bool SymmetricPeeling::settleIsthmuses(const BitWords& object) {
  std::rotate(fresh_.begin(), fresh_.end() - 1, fresh_.end());
  fresh_.front().clear();
  for (const auto& [begin, end] : object_spans_) {
    for (size_t i = begin; i < end; ++i) {
      if (const uint64_t fresh = isthmuses_[i] & ~seen_[i]; fresh != 0) {
        fresh_.front().push_back({i, fresh});
        seen_[i] |= fresh;
      }
      isthmuses_[i] = 0;
    }
  }
  const bool some =
      std::any_of(fresh_.begin(), fresh_.end(), [](const auto& f) { return !f.empty(); });
  for (const Bits& old : fresh_.back()) kept_[old.word] |= old.bits & object[old.word];
  return some;
}

void SymmetricPeeling::peel(const BitBox& box, int persistence, BitWords* object) {
  begin(box, persistence, *object);
  bool changed = true;
  for (int round = 0; changed; ++round) {
    listBorder(box, *object);
    judgeBorder();
    if (round == 0) keepEnds();
    candidate_words_.clear();
    for (const auto& [begin, end] : object_spans_)
      for (size_t i = begin; i < end; ++i)
        if (candidates_[i] != 0) candidate_words_.add(i);
    cliques_.keep(candidate_words_, *object, &candidates_, &isthmuses_);
    changed = removeCandidates(object);
    changed |= settleIsthmuses(*object);
  }
}

}  // namespace markerless_mocap
