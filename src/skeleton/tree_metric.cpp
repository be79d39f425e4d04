#include "skeleton/tree_metric.h"

#include <algorithm>
#include <limits>

namespace markerless_mocap {

TreeMetric::TreeMetric(const TreeChains& tree)
    : stride_(tree.vertices.size()),
      chains_at_(stride_),
      degrees_(stride_, 0),
      ways_(stride_ * stride_, std::numeric_limits<double>::infinity()),
      branches_(stride_, 0.0) {
  for (size_t i = 0; i < tree.chains.size(); ++i) {
    for (const int32_t v : {tree.chains[i].a, tree.chains[i].b}) {
      chains_at_[size_t(v)].push_back(int32_t(i));
      ++degrees_[size_t(v)];
    }
  }
  for (int32_t v = 0; v < int32_t(stride_); ++v) {
    if (degrees_[size_t(v)] == 0) continue;
    used_.push_back(v);
    measureFrom(v, tree);
    if (degrees_[size_t(v)] != 1) continue;
    ends_.push_back(v);
    branches_[size_t(v)] = tree.chains[size_t(chains_at_[size_t(v)][0])].length;
  }
  for (const int32_t a : ends_)
    for (const int32_t b : ends_) longest_ = std::max(longest_, way(a, b));
}

void TreeMetric::measureFrom(int32_t from, const TreeChains& tree) {
  double* ways = &ways_[size_t(from) * stride_];
  ways[from] = 0.0;
  std::vector<int32_t> open{from};
  while (!open.empty()) {
    const int32_t at = open.back();
    open.pop_back();
    for (const int32_t c : chains_at_[size_t(at)]) {
      const TreeChain& chain = tree.chains[size_t(c)];
      const int32_t to = chain.other(at);
      if (ways[to] <= ways[at] + chain.length) continue;
      ways[to] = ways[at] + chain.length;
      open.push_back(to);
    }
  }
}

}  // namespace markerless_mocap
