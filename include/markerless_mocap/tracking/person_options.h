#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the person: stature and shape estimate.
struct PersonOptions {
  static constexpr const char* kStage = "pose_fitting";
  /// height of the person, m
  double stature = 1.75;
  /// estimate the shape of the body from the first poses (contour); false: the
  /// proportions follow from the stature
  bool measure = true;
  /// standard deviation of the error of `stature` when the shape is estimated, m
  double stature_sigma = 0.08;
  /// number of different poses that the shape is estimated from
  int shape_poses = 30;

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
