#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "markerless_mocap/skeleton/pose_tree.h"

namespace markerless_mocap {

/// Ends of a body while left and right are not told apart.
enum class LimbEnd : uint8_t { kHead = 0, kHand1, kHand2, kFoot1, kFoot2 };
constexpr int kLimbEndCount = 5;

/// Which ends of a skeleton are a body's.
struct LabelChoice {
  TreeStatus status = TreeStatus::kTooFewBranches;
  std::string reason;                                           ///< one sentence unless kOk
  std::array<int32_t, kLimbEndCount> ends{-1, -1, -1, -1, -1};  ///< nodes of the graph, by LimbEnd
  int32_t origin = -1;                                          ///< node of the graph
  double rank = 0.0;
  double longest = 0.0;  ///< way between two ends, metres: the measure of the proportions
};

}  // namespace markerless_mocap
