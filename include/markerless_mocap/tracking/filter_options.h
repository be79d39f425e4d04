#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the output filter.
struct FilterOptions {
  static constexpr const char* kStage = "pose_fitting/filter";
  /// remove jitter from tf and joint_states; the topic pose is never filtered
  bool enabled = true;
  /// cutoff frequency for a body at rest, Hz; lower: less jitter
  double cutoff = 1.5;
  /// rise of the cutoff frequency with the fastest coordinate of the body, Hz per rad/s of a joint
  /// or of the root's rotation, or per m/s of the root; lower: less jitter in motion, but more
  /// delay
  double beta = 5.0;

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
