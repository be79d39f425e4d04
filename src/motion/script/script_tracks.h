#pragma once

#include <string>
#include <vector>

#include "motion/script/script_curve.h"

namespace markerless_mocap {

/// Quantities that a script sets by keys. Angles are degrees, lengths are fractions of the stature.
enum class Track {
  kDrop,      ///< how much lower the pelvis is than in standing
  kShift,     ///< pelvis forward and to the left
  kPelvis,    ///< pelvis tilts forward, leans to the left, turns to the left
  kTrunk,     ///< spine bends forward, leans to the left, turns to the left, from the pelvis on
  kHead,      ///< head nods, leans to the left, turns to the left, in addition to looking along the
              ///< path
  kArmSwing,  ///< factor of the arms' swing in walking
  kLeftArm,   ///< forward, outward, twist inward of the upper arm, bend of the elbow
  kRightArm,  ///< the same, mirrored
  kLeftWrist,  ///< forearm turns the palm (from facing the thigh) backwards, hand bends to the palm
  kRightWrist,  ///< the same, mirrored
  kLeftReach,   ///< weight, then position of the wrist relative to the shoulder in the chest's
                ///< frame, arm lengths: forward, outward, up
  kRightReach,  ///< the same, mirrored
  kLeftGrasp,   ///< weight, then position of the wrist relative to the person's position on the
                ///< floor: forward, outward, up
  kRightGrasp,  ///< the same, mirrored
};
constexpr int kTrackCount = 14;

struct TrackRow {
  std::string name;
  CurveValues neutral;
  CurveValues minimum;
  CurveValues maximum;
};

const TrackRow& trackRow(Track track);
std::vector<std::string> trackNames();

}  // namespace markerless_mocap
