#pragma once

#include <set>
#include <string>

#include "markerless_mocap/contour/contour_options.h"
#include "markerless_mocap/fleischmann/fleischmann_options.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/options/options.h"
#include "markerless_mocap/tracking/filter_options.h"
#include "markerless_mocap/tracking/person_options.h"

namespace markerless_mocap {

/// Settings of the tracker: which method follows the person, and the methods' own.
struct TrackerOptions {
  static constexpr const char* kStage = "pose_fitting";
  /// how the person is tracked; contour: fit a body to the contours of the silhouettes; hsiao: fit
  /// a body to part curves and hull (Hsiao 2008); fleischmann: search by silhouettes and edges
  /// (Fleischmann 2012)
  std::string method = "contour";
  PersonOptions person;
  /// output filter of tf and joint_states (Casiez et al. 2012)
  FilterOptions filter;
  /// the method contour
  ContourOptions contour;
  /// the method hsiao, which also proposes start poses to the other methods
  HsiaoOptions hsiao;
  /// the method fleischmann
  FleischmannOptions fleischmann;

  void visit(OptionVisitor& v);
  /// Keys of what cannot be changed while a tracker follows a person: the method and its sections.
  static std::set<std::string> fixedKeys() { return {"method", "contour", "hsiao", "fleischmann"}; }
  void validate() const;
};

}  // namespace markerless_mocap
