#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

/// Extremities of a body before left and right are known.
enum class UnsidedExtremity : uint8_t { kHead = 0, kHand1, kHand2, kFoot1, kFoot2 };
constexpr int kUnsidedExtremityCount = 5;

/// Opens a loop at another edge than the graph's tree does: the edge from `cut` to its parent is
/// removed, the edge from `from` to `to` is added.
struct EdgeExchange {
  int32_t cut, from, to;
};

/// The ends of a skeleton that are chosen as extremities.
struct LabelChoice {
  TreeStatus status = TreeStatus::kTooFewBranches;
  std::string reason;  ///< message for the user unless kOk
  std::array<int32_t, kUnsidedExtremityCount> extremities{
      -1, -1, -1, -1, -1};  ///< nodes of the graph, by UnsidedExtremity
  int32_t origin = -1;      ///< node of the graph
  double rank = 0.0;
  /// Whether an extremity lies on a loop, by UnsidedExtremity.
  std::array<bool, kUnsidedExtremityCount> closed{};
  std::vector<EdgeExchange> edge_exchanges;
  /// Longest path between two extremities, metres: the unit of the proportions.
  double longest = 0.0;
};

}  // namespace markerless_mocap
