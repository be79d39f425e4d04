#include "skeleton/critical_cliques.h"

#include "skeleton/clique_kernels.h"

namespace markerless_mocap {

using clique_kernels::Found;
using clique_kernels::Strides;

CriticalCliques::CriticalCliques(const BitBox& box) : box_(box) {
  for (int axis = 0; axis < 3; ++axis) {
    critical_[axis].assign(box.words, 0);
    joining_[axis].assign(box.words, 0);
  }
}

void CriticalCliques::keepPairs(const WordSpans& spans, const BitWords& object,
                                BitWords* candidates, BitWords* isthmuses) {
  const Strides strides{ptrdiff_t(box_.row), ptrdiff_t(box_.plane)};
  Found found;
  for (const auto& [begin, end] : spans) {
    for (int axis = 0; axis < 3; ++axis) {
      clique_kernels::pairs(axis, strides, object.data(), candidates->data(), begin, end,
                            critical_[axis].data(), joining_[axis].data(), &found);
    }
  }
  if (found.critical == 0) return;
  for (const auto& [begin, end] : spans) {
    clique_kernels::clearPairs(strides, critical_, begin, end, candidates->data());
    if (found.joining != 0)
      clique_kernels::addPairs(strides, joining_, begin, end, isthmuses->data());
  }
}

void CriticalCliques::keepEdges(const WordSpans& spans, const BitWords& object,
                                BitWords* candidates, BitWords* isthmuses) {
  const Strides strides{ptrdiff_t(box_.row), ptrdiff_t(box_.plane)};
  Found found;
  for (const auto& [begin, end] : spans) {
    for (int axis = 0; axis < 3; ++axis) {
      clique_kernels::edges(axis, strides, object.data(), candidates->data(), begin, end,
                            critical_[axis].data(), joining_[axis].data(), &found);
    }
  }
  if (found.critical == 0) return;
  for (const auto& [begin, end] : spans) {
    if (found.joining != 0)
      clique_kernels::addEdges(strides, object.data(), joining_, begin, end, isthmuses->data());
    clique_kernels::clearEdges(strides, critical_, begin, end, candidates->data());
  }
}

void CriticalCliques::keepCorners(const WordSpans& spans, const BitWords& object,
                                  BitWords* candidates) {
  const Strides strides{ptrdiff_t(box_.row), ptrdiff_t(box_.plane)};
  Found found;
  for (const auto& [begin, end] : spans) {
    clique_kernels::corners(strides, object.data(), candidates->data(), begin, end,
                            critical_[0].data(), &found);
  }
  if (found.critical == 0) return;
  for (const auto& [begin, end] : spans)
    clique_kernels::clearCorners(strides, critical_[0].data(), begin, end, candidates->data());
}

void CriticalCliques::keep(const WordSpans& spans, const BitWords& object, BitWords* candidates,
                           BitWords* isthmuses) {
  keepPairs(spans, object, candidates, isthmuses);
  keepEdges(spans, object, candidates, isthmuses);
  keepCorners(spans, object, candidates);
}

}  // namespace markerless_mocap
