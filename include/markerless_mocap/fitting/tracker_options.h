#pragma once

#include <string>

#include "markerless_mocap/contour/contour_options.h"
#include "markerless_mocap/fitting/fitting_options.h"
#include "markerless_mocap/fitting/sppso_options.h"
#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the tracker: which method follows the person, and the methods' own.
struct TrackerOptions {
  static constexpr const char* kStage = "pose_fitting";
  std::string method = "contour";
  bool measure = true;
  double stature_deviation = 0.08;
  int measuring_poses = 30;
  bool filter = true;
  double filter_cutoff = 1.5;
  double filter_beta = 5.0;
  FittingOptions skeleton;  ///< stature and seed are everybody's
  ContourOptions contour;   ///< keys begin with contour_
  SppsoOptions sppso;       ///< keys begin with sppso_; keep_start, which the thesis lacks, is on

  TrackerOptions() { sppso.keep_start = true; }
  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
