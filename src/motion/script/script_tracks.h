#pragma once

#include <string>
#include <vector>

#include "motion/script/script_curve.h"

namespace markerless_mocap {

/// What a script drives by keys. Angles are degrees, lengths are shares of the stature.
enum class Track {
  kDrop,       ///< how much lower the pelvis is than in standing
  kShift,      ///< pelvis forward and to the left
  kPelvis,     ///< pelvis tilts forward, leans to the left, turns to the left
  kTrunk,      ///< spine bends forward, leans to the left, turns to the left, from the pelvis on
  kHead,       ///< head nods, leans to the left, turns to the left, beside looking where one goes
  kArmSwing,   ///< factor of the arms' swing in walking
  kLeftArm,    ///< forward, outward, twist inward of the upper arm, elbow's bend
  kRightArm,   ///< the same, mirrored
  kLeftWrist,  ///< forearm turns the palm (from facing the thigh) backwards, hand bends to the palm
  kRightWrist,  ///< the same, mirrored
  kLeftReach,   ///< share, then the wrist from the shoulder in the chest's frame, in arm lengths:
                ///< forward, outward, up
  kRightReach,  ///< the same, mirrored
  kLeftGrasp,  ///< share, then the wrist from the person's place on the floor: forward, outward, up
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
