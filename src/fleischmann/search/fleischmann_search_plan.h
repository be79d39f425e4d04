#pragma once

#include <memory>
#include <vector>

#include "fleischmann/fleischmann_fitness.h"
#include "markerless_mocap/fleischmann/fleischmann_options.h"
#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// How a frame is searched: the optimiser, and the edges that each of its stages looks at.
struct FleischmannSearchPlan {
  std::shared_ptr<const Optimiser> optimiser;
  std::vector<EdgeSelection> edges;
};

/// The partitions of Fleischmann 2012, Tables 6.1 and 6.3, 6.5 and 6.6:
/// two_soft: 10 x 20 on pelvis turn and place, then 20 x 40 on all with a tenth of the place's
///   sigma; one_global: 25 x 40; two_hard: as two_soft, the first six held in the second stage;
/// three_soft: 10 x 20, 10 x 40 without lower limbs and twists, 10 x 40;
/// twelve_hard: 10 x 60 each after John et al. 2010;
/// annealed_filter, interacting_annealing: 200 particles in 5 layers.
/// The head's twist is always held. Throws std::invalid_argument on options out of range.
FleischmannSearchPlan makeSearchPlan(const FleischmannOptions& options);

}  // namespace markerless_mocap
