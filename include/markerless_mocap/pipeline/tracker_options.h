#pragma once

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
  std::string method = "contour";
  PersonOptions person;
  FilterOptions filter;
  ContourOptions contour;
  HsiaoOptions hsiao;
  FleischmannOptions fleischmann;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
