#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "fleischmann/fleischmann_fitness.h"
#include "markerless_mocap/fleischmann/fleischmann_options.h"
#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// As StagedSwarmSettings::watch.
using SwarmWatch = std::function<void(int stage, const Eigen::MatrixXd& positions)>;

/// Search of one frame: the optimiser, and the edges for each of its stages.
struct FleischmannSearchPlan {
  std::shared_ptr<const Optimiser> optimiser;
  std::vector<EdgeSelection> edges;
};

/// The partitions of Fleischmann 2012, Tables 6.1, 6.3, 6.5 and 6.6:
/// - two_soft: 10 x 20 (iterations x particles) on pelvis orientation and position, then 20 x 40 on
///   all parameters with a tenth of the position's sigma
/// - one_global: 25 x 40
/// - two_hard: as two_soft, with the first six parameters fixed in the second stage
/// - three_soft: 10 x 20, 10 x 40 without lower limbs and twists, 10 x 40
/// - twelve_hard: 10 x 60 each, after John et al. 2010
/// - annealed_filter, interacting_annealing: 200 particles in 5 layers
/// The twist of the head is always fixed. Throws std::invalid_argument if an option is out of
/// range.
/// \param watch of the swarms; the filters do not call it
FleischmannSearchPlan makeSearchPlan(const FleischmannOptions& options,
                                     const SwarmWatch& watch = nullptr);

}  // namespace markerless_mocap
