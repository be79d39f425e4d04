#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// The system as published with some options changed.
struct FleischmannVariant {
  std::string id;     ///< in names of runs
  std::string name;   ///< in tables
  Overrides changes;  ///< of pose_fitting/fleischmann
  int fps = 20;       ///< 60 or 20
  int runs = 5;       ///< seeds of the thesis
  int evaluations = 1000;
  bool exact = false;            ///< silhouettes without damage
  double mean = NAN, max = NAN;  ///< of D in the thesis, mm; NaN: it only has a graph
  double cost() const { return double(evaluations) * fps / 20.0; }
};

/// Variants that one table or figure of chapter 6 compares.
struct FleischmannTable {
  std::string id, title;
  std::vector<std::string> variants;  ///< ids
};

/// All variants, the base configuration at 60 and 20 fps first ("base60", "base20").
const std::vector<FleischmannVariant>& fleischmannVariants();
/// Throws std::invalid_argument if there is none.
const FleischmannVariant& fleischmannVariant(const std::string& id);
const std::vector<FleischmannTable>& fleischmannTables();

}  // namespace markerless_mocap
