#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings that say who is followed.
struct PersonOptions {
  static constexpr const char* kStage = "pose_fitting";
  double stature = 1.75;            ///< height of the person, metres
  bool measure = true;              ///< measure the body's sizes before the first pose is claimed
  double stature_deviation = 0.08;  ///< standard deviation of the stature's error, metres
  int measuring_poses = 30;         ///< different poses that the body is measured from

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
