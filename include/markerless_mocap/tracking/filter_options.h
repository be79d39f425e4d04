#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the output filter.
struct FilterOptions {
  static constexpr const char* kStage = "pose_fitting";
  bool enabled = true;  ///< free tf and joint_states from jitter
  double cutoff = 1.5;  ///< for a body at rest, Hz
  double beta = 5.0;    ///< rise of the cutoff with speed, Hz per rad/s or m/s

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
