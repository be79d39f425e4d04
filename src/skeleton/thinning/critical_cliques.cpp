#include "skeleton/thinning/critical_cliques.h"

namespace markerless_mocap {

using namespace clique_kernels;

void CriticalCliques::resize(const BitBox& box) {
  box_ = box;
  words_ = WordSet(box.words);
  for (int axis = 0; axis < 3; ++axis) {
    cliques_.critical[axis].assign(box.words, 0);
    cliques_.isthmus[axis].assign(box.words, 0);
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

void CriticalCliques::keep(const WordSet& candidate_words, const BitWords& object,
                           BitWords* candidates, BitWords* isthmuses) {
  listSpans(candidate_words);
  uint64_t *const left = candidates->data(), *const isthmus = isthmuses->data();
  const Found pairs = findPairs(box_, spans_, object.data(), left, &cliques_);
  if (pairs.critical != 0) removePairs(box_, spans_, cliques_, pairs.isthmus != 0, left, isthmus);
  const Found edges = findEdges(box_, spans_, object.data(), left, &cliques_);
  if (edges.critical != 0) removeEdges(box_, spans_, cliques_, edges.isthmus != 0, left, isthmus);
  const Found corners = findCorners(box_, spans_, object.data(), left, &cliques_);
  if (corners.critical != 0) removeCorners(box_, spans_, cliques_, left);
}

}  // namespace markerless_mocap
