#include "skeleton/critical_cliques.h"

#include "skeleton/clique_kernels.h"

namespace markerless_mocap {

using clique_kernels::Cliques;
using clique_kernels::Found;

void CriticalCliques::resize(const BitBox& box) {
  box_ = box;
  words_ = WordSet(box.words);
  for (int axis = 0; axis < 3; ++axis) {
    critical_[axis].assign(box.words, 0);
    joining_[axis].assign(box.words, 0);
  }
}

void CriticalCliques::listSpans(const WordSet& candidate_words) {
  words_.clear();
  for (size_t by : {size_t(0), box_.row, box_.plane, box_.plane + box_.row}) {
    words_.addBefore(candidate_words, by);
    if (box_.row > 1) words_.addBefore(candidate_words, by + 1);
  }
  words_.list(&spans_);
}

void CriticalCliques::keepPairs(const BitWords& object, BitWords* candidates, BitWords* isthmuses) {
  Found found;
  for (const auto& [begin, end] : spans_)
    for (int axis = 0; axis < 3; ++axis)
      clique_kernels::pairs(box_, axis, begin, end, object.data(), candidates->data(),
                            {critical_[axis].data(), joining_[axis].data()}, &found);
  if (found.critical == 0) return;
  for (const auto& [begin, end] : spans_) {
    if (found.joining != 0)
      clique_kernels::addPairs(box_, joining_, begin, end, candidates->data(), isthmuses->data());
    clique_kernels::clearPairs(box_, critical_, begin, end, candidates->data());
  }
}

void CriticalCliques::keepEdges(const BitWords& object, BitWords* candidates, BitWords* isthmuses) {
  Found found;
  for (const auto& [begin, end] : spans_)
    for (int axis = 0; axis < 3; ++axis)
      clique_kernels::edges(box_, axis, begin, end, object.data(), candidates->data(),
                            {critical_[axis].data(), joining_[axis].data()}, &found);
  if (found.critical == 0) return;
  for (const auto& [begin, end] : spans_) {
    if (found.joining != 0)
      clique_kernels::addEdges(box_, joining_, begin, end, candidates->data(), isthmuses->data());
    clique_kernels::clearEdges(box_, critical_, begin, end, candidates->data());
  }
}

void CriticalCliques::keepCorners(const BitWords& object, BitWords* candidates) {
  Found found;
  for (const auto& [begin, end] : spans_)
    clique_kernels::corners(box_, begin, end, object.data(), candidates->data(),
                            critical_[0].data(), &found);
  if (found.critical == 0) return;
  for (const auto& [begin, end] : spans_)
    clique_kernels::clearCorners(box_, critical_[0], begin, end, candidates->data());
}

void CriticalCliques::keep(const WordSet& candidate_words, const BitWords& object,
                           BitWords* candidates, BitWords* isthmuses) {
  listSpans(candidate_words);
  keepPairs(object, candidates, isthmuses);
  keepEdges(object, candidates, isthmuses);
  keepCorners(object, candidates);
}

}  // namespace markerless_mocap
