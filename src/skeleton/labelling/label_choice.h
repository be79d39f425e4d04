#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

/// Ends of a body while left and right are not told apart.
enum class UnsidedExtremity : uint8_t { kHead = 0, kHand1, kHand2, kFoot1, kFoot2 };
constexpr int kUnsidedExtremityCount = 5;

/// A place where a loop is opened elsewhere than the graph's tree does: `cut` leaves its parent,
/// `from` and `to` hold together.
struct EdgeExchange {
  int32_t cut, from, to;
};

/// Which ends of a skeleton are a body's.
struct LabelChoice {
  TreeStatus status = TreeStatus::kTooFewBranches;
  std::string reason;  ///< one sentence unless kOk
  std::array<int32_t, kUnsidedExtremityCount> extremities{
      -1, -1, -1, -1, -1};  ///< nodes of the graph, by UnsidedExtremity
  int32_t origin = -1;      ///< node of the graph
  double rank = 0.0;
  std::array<bool, kUnsidedExtremityCount>
      closed{};  ///< whether an end is a place in a loop, by UnsidedExtremity
  std::vector<EdgeExchange> edge_exchanges;
  double longest = 0.0;  ///< way between two ends, metres: the measure of the proportions
};

}  // namespace markerless_mocap
