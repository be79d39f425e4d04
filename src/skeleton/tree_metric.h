#pragma once

#include <cstdint>
#include <vector>

#include "skeleton/tree_chains.h"

namespace markerless_mocap {

/// Lengths of the ways between the vertices of chains that form a tree.
class TreeMetric {
 public:
  explicit TreeMetric(const TreeChains& tree);

  const std::vector<int32_t>& vertices() const { return used_; }  ///< those with a chain
  const std::vector<int32_t>& ends() const { return ends_; }      ///< those with one chain
  double way(int32_t from, int32_t to) const { return ways_[size_t(from) * stride_ + size_t(to)]; }
  int degree(int32_t vertex) const { return degrees_[size_t(vertex)]; }
  /// Length of the chain at an end.
  double branch(int32_t end) const { return branches_[size_t(end)]; }
  /// Longest way between two ends.
  double longest() const { return longest_; }

 private:
  void measureFrom(int32_t from, const TreeChains& tree);

  size_t stride_;
  std::vector<std::vector<int32_t>> chains_at_;
  std::vector<int32_t> used_, ends_;
  std::vector<int> degrees_;
  std::vector<double> ways_, branches_;
  double longest_ = 0.0;
};

}  // namespace markerless_mocap
