#pragma once

#include "hsiao/fit/hsiao_stages.h"

namespace markerless_mocap {

/// One swarm: what it searches, and by which parts.
struct HsiaoHierarchicalFitter::Search {
  hsiao_stages::Parameters parameters;
  hsiao_stages::Active active;
  HsiaoBounds range;
  uint64_t seed;
  bool is_fine_tuning = false;            // of a size of its own, whatever the parameters
  std::vector<HsiaoVector> guesses = {};  // in addition to the current vector
};

}  // namespace markerless_mocap
