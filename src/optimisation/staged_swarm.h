#pragma once

#include <vector>

#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// One stage: a complete swarm search. The next stage starts at its result.
struct SwarmStage {
  int particles = 20;
  int iterations = 40;
  /// Factor of each parameter's sigma. 0 fixes the parameter (hard partition); a small factor
  /// permits a correction (soft partition).
  Eigen::VectorXd sigma_scale;
};

/// Settings of all stages (Fleischmann 2012, 5.3.2).
struct StagedSwarmSettings {
  /// One particle of each stage starts at the centre, so that no stage ends with a higher cost than
  /// it began.
  bool keep_center = false;
  double initial_acceleration = 2.05, final_acceleration = 2.15;  ///< c1 = c2, above 2
  double max_velocity = 2.0;                                      ///< sigmas per iteration
  /// Called after each iteration with its stage and the positions, one column per particle; not
  /// from several threads at once within one search.
  std::function<void(int stage, const Eigen::MatrixXd& positions)> watch = nullptr;
};

/// The constriction factor chi of Clerc and Kennedy 2002 for phi = c1 + c2 > 4 (Eq. 5.9).
double constriction(double phi);

/// Soft partitioning particle swarm optimisation (SPPSO; Fleischmann 2012, 5.3): stages of a swarm
/// with constriction factor and global best. Positions start at N(centre, sigma^2), velocities at
/// U(-sigma, sigma); velocities are limited to some sigmas. c1 = c2 rise linearly over the
/// iterations. A move that violates a constraint is drawn again.
class StagedSwarm : public Optimiser {
 public:
  /// Throws std::invalid_argument without stages, particles or iterations, if a sigma_scale is
  /// negative or of a different size, or on an acceleration of 2 or less.
  explicit StagedSwarm(std::vector<SwarmStage> stages, StagedSwarmSettings settings = {});
  SearchOutcome minimise(const SearchProblem& problem, const SearchStart& start,
                         uint64_t seed) const override;
  const std::vector<SwarmStage>& stages() const { return stages_; }
  /// Number of cost evaluations of one search.
  int evaluations() const;

 private:
  std::vector<SwarmStage> stages_;
  StagedSwarmSettings settings_;
};

}  // namespace markerless_mocap
