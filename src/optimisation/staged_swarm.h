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

/// The constriction factor chi of Clerc and Kennedy 2002 for phi = c1 + c2 > 4 (Eq. 5.9).
double constriction(double phi);

/// Soft partitioning particle swarm optimisation (SPPSO; Fleischmann 2012, 5.3): stages of a swarm
/// with constriction factor and global best. Positions start at N(centre, sigma^2), velocities at
/// U(-sigma, sigma); velocities are limited to 2 sigma. c1 = c2 rise linearly from 2.05 to 2.15
/// over the iterations. A move that violates a constraint is drawn again.
class StagedSwarm : public Optimiser {
 public:
  /// \param keep_center one particle of each stage starts at the centre, so that no stage ends with
  ///   a higher cost than it began
  /// Throws std::invalid_argument without stages, particles or iterations, or if a sigma_scale is
  /// negative or of a different size.
  explicit StagedSwarm(std::vector<SwarmStage> stages, bool keep_center = false);
  SearchOutcome minimise(const SearchProblem& problem, const SearchStart& start,
                         uint64_t seed) const override;
  const std::vector<SwarmStage>& stages() const { return stages_; }
  /// Number of cost evaluations of one search.
  int evaluations() const;

 private:
  std::vector<SwarmStage> stages_;
  bool keep_center_;
};

}  // namespace markerless_mocap
