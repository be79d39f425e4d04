#pragma once

#include <array>

#include "markerless_mocap/segmentation/body_parts.h"
#include "markerless_mocap/segmentation/branch_measures.h"

namespace markerless_mocap {

/// Which branch is which part.
struct BranchNames {
  std::array<int, kPartCount> branch;  ///< by PartLabel, -1 where none fits; the torso has none
  /// Mean clipped squared z-score of what was named, against human bodies; infinity for nothing.
  double cost;
};

/// Names branches by volume, length, thickness and the ways between tips, which need no body model
/// and no up direction: of all assignments of branches to head, arms and legs the one with the
/// least sum of clipped squared z-scores, where a part left out costs nothing and a part named must
/// pay for itself. Of the two arms (legs) the first has the earlier branch.
BranchNames nameBranches(const BranchMeasures& measures);

}  // namespace markerless_mocap
