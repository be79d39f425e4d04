#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace markerless_mocap {

/// What is to be minimised. Both functions are called from several threads at once.
struct SearchProblem {
  /// Costs of `count` candidates that stand one behind the other. Optimisers with stages tell which
  /// one is asking, from 0; what is not finite counts as infinitely bad.
  std::function<void(int stage, const double* candidates, int count, double* costs)> cost;
  /// Candidates that may not be, beyond the bounds; empty: none.
  std::function<bool(const double* candidate)> infeasible;
  Eigen::VectorXd lower, upper;  ///< bounds; infinite where there are none
};

/// Where a search begins.
struct SearchStart {
  Eigen::VectorXd center;
  Eigen::VectorXd sigma;  ///< how far each parameter may be off: standard deviations; 0 holds it
};

/// What a search found.
struct SearchOutcome {
  Eigen::VectorXd best;  ///< the start's centre when nothing was found
  double cost = 0.0;
  bool found = false;      ///< some candidate had a finite cost
  int evaluations = 0;     ///< candidates whose cost was asked for
  int rejected_moves = 0;  ///< moves given up because no draw met the constraints
};

/// One interface for all: candidates in, costs out. Stateless: a search depends on its arguments
/// alone, not on the number of threads.
class Optimiser {
 public:
  virtual ~Optimiser() = default;
  /// Throws std::invalid_argument if sizes differ, bounds cross, or sigmas are negative.
  virtual SearchOutcome minimise(const SearchProblem& problem, const SearchStart& start,
                                 uint64_t seed) const = 0;
};

/// Throws std::invalid_argument if there is no cost, or bounds differ in size or cross.
void validateProblem(const SearchProblem& problem);
/// Throws as Optimiser::minimise() says.
void validateProblem(const SearchProblem& problem, const SearchStart& start);

/// Whether a candidate is finite, inside the bounds and not forbidden.
bool isFeasible(const SearchProblem& problem, const double* candidate);

/// A draw that must meet the constraints has this many attempts (Fleischmann 2012, 5.3.2).
constexpr int kDrawAttempts = 10;

/// Draws candidates with `draw(attempt, candidate)` until one is allowed. Failing that, the last
/// one is moved inside the bounds; failing that too, `candidate` is set to `fallback`.
/// \return false when it was
bool drawFeasible(
    const SearchProblem& problem, const Eigen::VectorXd& fallback,
    const std::function<void(int attempt, Eigen::Ref<Eigen::VectorXd> candidate)>& draw,
    Eigen::Ref<Eigen::VectorXd> candidate);

}  // namespace markerless_mocap
