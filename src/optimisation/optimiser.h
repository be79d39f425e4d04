#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace markerless_mocap {

/// A minimisation problem. Both functions are called from several threads.
struct SearchProblem {
  /// Computes the costs of `count` candidates that are stored one after the other. `stage` is the
  /// index of the calling stage, from 0. A cost that is not finite counts as infinite.
  std::function<void(int stage, const double* candidates, int count, double* costs)> cost;
  /// Whether a candidate inside the bounds is infeasible; empty: none is.
  std::function<bool(const double* candidate)> infeasible;
  Eigen::VectorXd lower, upper;  ///< bounds; infinite if there are none
  /// Number of attempts of a draw that must meet the constraints (Fleischmann 2012, 5.3.2).
  int attempts = 10;
};

/// Start of a search.
struct SearchStart {
  Eigen::VectorXd center;
  Eigen::VectorXd sigma;  ///< standard deviation of each parameter; 0: the parameter is fixed
  /// Particles of an earlier search, one per column, around which an annealed particle filter
  /// scatters its first ones; empty: around the centre. Other optimisers do not use them.
  Eigen::MatrixXd particles = {};
};

/// Result of a search.
struct SearchOutcome {
  Eigen::VectorXd best;  ///< the start's centre if nothing was found
  double cost = 0.0;
  bool found = false;      ///< whether a candidate had a finite cost
  int evaluations = 0;     ///< number of candidates whose cost was computed
  int rejected_moves = 0;  ///< number of moves for which no draw met the constraints
  /// Of an annealed particle filter: its last particles, drawn by weight; of others empty.
  Eigen::MatrixXd particles = {};
};

/// Interface of all optimisers. Stateless: the result depends on the arguments only, not on the
/// number of threads.
class Optimiser {
 public:
  virtual ~Optimiser() = default;
  /// Throws std::invalid_argument if sizes differ, a lower bound is above the upper one, or a sigma
  /// is negative.
  virtual SearchOutcome minimise(const SearchProblem& problem, const SearchStart& start,
                                 uint64_t seed) const = 0;
};

/// Throws std::invalid_argument if there is no cost, or bounds differ in size or cross.
void validateProblem(const SearchProblem& problem);
/// Throws std::invalid_argument as Optimiser::minimise().
void validateProblem(const SearchProblem& problem, const SearchStart& start);

/// Whether a candidate is finite, inside the bounds and not infeasible.
bool isFeasible(const SearchProblem& problem, const double* candidate);

/// Draws candidates with `draw(attempt, candidate)` until one is feasible. If none is, the last one
/// is moved inside the bounds. If that is not feasible either, `candidate` is set to `fallback`.
/// \return false if `fallback` was used
bool drawFeasible(
    const SearchProblem& problem, const Eigen::VectorXd& fallback,
    const std::function<void(int attempt, Eigen::Ref<Eigen::VectorXd> candidate)>& draw,
    Eigen::Ref<Eigen::VectorXd> candidate);

}  // namespace markerless_mocap
