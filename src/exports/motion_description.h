#pragma once

#include <string>
#include <vector>

#include "exports/person_motion.h"

namespace markerless_mocap {

/// A value with the error that is expected of it from the expected errors of the limbs' ends; NaN:
/// unknown.
struct Measure {
  double value, error;
};

/// Several values of one kind. Errors of following steps are alike: they do not average out, and
/// the mean has the root mean square of their errors.
struct Average {
  size_t count = 0;
  double mean, deviation;  ///< NaN without a value; the deviation is that between the values
  double error;            ///< expected of the mean
};
Average averageOf(const std::vector<Measure>& measures);

/// A foot that is put down after it was lifted, and carried on by at least kMinStride_m.
struct Step {
  bool left = false;
  double seconds = 0.0;  ///< at which the foot lands, since the first frame of the motion
  /// From the place of the other foot, along the way from this foot's last place to its new one,
  /// and across it, m (Huxham et al. 2006: also on curved paths). The width is negative if the
  /// feet cross.
  Measure length_m, width_m;
  Measure step_s;     ///< since the other foot landed; NaN: more than kMaxStep_s ago
  Measure contact_s;  ///< until the foot is lifted again; NaN: after the end, or not seen
};
constexpr double kMinStride_m = 0.1;
constexpr double kMaxStep_s = 1.5;

/// Steps in the order of time. A foot is on the floor while its heel or its ball rests there, see
/// evaluation/foot_contact.h; the floor is assumed to be level.
std::vector<Step> stepsOf(const PersonMotion& motion);

/// Percentiles 1 and 99 of a joint's angle, degrees, over the frames in which it is seen.
struct JointRange {
  std::string joint;  ///< of the URDF, without id
  double low_deg, high_deg;
  /// The error is that of the limb's end seen from the joint's axis.
  Measure range_deg;
};
std::vector<JointRange> jointRanges(const PersonMotion& motion);

/// Lean of the line from pelvis to shoulders against the vertical, degrees.
struct TrunkLean {
  Average forward, left;             ///< in the direction in which the pelvis faces
  double forward_low, forward_high;  ///< percentiles 1 and 99
  double left_low, left_high;
};
TrunkLean trunkLean(const PersonMotion& motion);

struct MotionDescription {
  double seconds = 0.0;
  size_t frames = 0, frames_with_pose = 0;
  std::vector<Step> steps;
  /// Of both feet; contacts of more than kMaxStep_s, of somebody who stands, are left out.
  Average cadence_per_min, length_m, width_m, contact_s;
  Average left_length_m, right_length_m, left_contact_s, right_contact_s;
  TrunkLean lean;
  std::vector<JointRange> ranges;
};
MotionDescription describe(const PersonMotion& motion);

}  // namespace markerless_mocap
