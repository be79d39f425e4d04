#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"

namespace markerless_mocap {

/// A limb is lost while its end is farther off than kExtremityLimit_mm or is not published. Losses
/// less than kSameLoss_s apart are one.
constexpr double kSameLoss_s = 0.2;

/// How often one limb was lost after the first pose.
struct LimbLoss {
  std::string limb, end;                  ///< as left_arm, and its marker, l_wrist
  size_t frames = 0;                      ///< judged: from the first pose on, with a truth
  size_t far_off = 0, not_published = 0;  ///< frames
  size_t losses = 0;
  double per_minute;     ///< losses; NaN below two frames
  double fraction_lost;  ///< of the frames; NaN without any
  double longest_s = 0.0;
  std::vector<bool> lost;  ///< per frame of the truth, as seen frame by frame
};

/// Head by the marker of that name, arms by wrists, legs by ankles.
/// \param truth, estimate tracks of the same frames, throws std::invalid_argument otherwise
std::vector<LimbLoss> limbLosses(const JointTrack& truth, const JointTrack& estimate);

}  // namespace markerless_mocap
