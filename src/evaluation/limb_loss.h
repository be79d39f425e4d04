#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"

namespace markerless_mocap {

/// A limb is lost while the error of its end exceeds kExtremityLimit_mm or its end is not
/// published. Losses less than kSameLoss_s apart count as one.
constexpr double kSameLoss_s = 0.2;

/// Losses of one limb after the first pose.
struct LimbLoss {
  std::string limb, end;                  ///< for example left_arm, and its marker l_wrist
  size_t frames = 0;                      ///< evaluated frames: from the first pose on, with truth
  size_t far_off = 0, not_published = 0;  ///< numbers of frames
  size_t losses = 0;
  double per_minute;     ///< losses per minute; NaN below two frames
  double fraction_lost;  ///< fraction of the frames; NaN without any
  double longest_s = 0.0;
  std::vector<bool> lost;  ///< per frame of the truth, before close losses are joined
};

/// Losses of head, arms and legs, by the markers head, wrists and ankles.
/// \param truth, estimate tracks of the same frames, throws std::invalid_argument otherwise
std::vector<LimbLoss> limbLosses(const JointTrack& truth, const JointTrack& estimate);

}  // namespace markerless_mocap
