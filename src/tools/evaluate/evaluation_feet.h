#pragma once

#include <array>
#include <vector>

#include "evaluation/foot_contact.h"
#include "evaluation/limb_loss.h"
#include "tools/common/result_record.h"

namespace markerless_mocap {

/// Contact of one foot with the floor.
struct FootEvaluation {
  FootContact ball, ankle;
  std::vector<double> sole_m;  ///< height of the estimated sole per frame; NaN without a pose
  SoleStatistics sole;
  std::vector<double> true_ball_mm, ball_mm;  ///< heights of the true and the estimated ball per
                                              ///< frame
};

/// Left and right.
using FeetEvaluation = std::array<FootEvaluation, 2>;

/// \param truth with bodyPointNames()
/// \param match index of the result for each frame of the ground truth, or -1
FeetEvaluation evaluateFeet(const JointTrack& truth, const ResultRecord& results,
                            const std::vector<int>& match);

}  // namespace markerless_mocap
