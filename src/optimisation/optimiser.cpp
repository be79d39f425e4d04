#include "optimisation/optimiser.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace markerless_mocap {

namespace {
std::string parameter(Eigen::Index d) {
  return "parameter " + std::to_string(d) + " of a search";
}
}  // namespace

void validateProblem(const SearchProblem& problem) {
  if (!problem.cost) throw std::invalid_argument("a search needs a cost");
  if (problem.lower.size() < 1 || problem.lower.size() != problem.upper.size())
    throw std::invalid_argument("a search needs as many lower bounds as upper ones, at least one");
  for (Eigen::Index d = 0; d < problem.lower.size(); ++d)
    if (!(problem.lower[d] <= problem.upper[d]))
      throw std::invalid_argument(parameter(d) + " has a lower bound above its upper one");
}

void validateProblem(const SearchProblem& problem, const SearchStart& start) {
  validateProblem(problem);
  const auto size = start.center.size();
  if (start.sigma.size() != size || problem.lower.size() != size)
    throw std::invalid_argument(
        "a search needs a centre, and as many sigmas and bounds as the centre has values");
  if (start.particles.size() > 0 && start.particles.rows() != size)
    throw std::invalid_argument("a search needs particles of as many values as the centre");
  for (Eigen::Index d = 0; d < size; ++d) {
    if (!std::isfinite(start.center[d]))
      throw std::invalid_argument(parameter(d) + " starts at a value that is not finite");
    if (!(start.sigma[d] >= 0.0 && std::isfinite(start.sigma[d])))
      throw std::invalid_argument(parameter(d) + " needs a finite sigma of at least 0");
  }
}

bool isFeasible(const SearchProblem& problem, const double* candidate) {
  for (Eigen::Index d = 0; d < problem.lower.size(); ++d)
    if (!(candidate[d] >= problem.lower[d] && candidate[d] <= problem.upper[d])) return false;
  return !problem.infeasible || !problem.infeasible(candidate);
}

bool drawFeasible(const SearchProblem& problem, const Eigen::VectorXd& fallback,
                  const std::function<void(int, Eigen::Ref<Eigen::VectorXd>)>& draw,
                  Eigen::Ref<Eigen::VectorXd> candidate) {
  for (int attempt = 0; attempt < problem.attempts; ++attempt) {
    draw(attempt, candidate);
    if (isFeasible(problem, candidate.data())) return true;
  }
  candidate = candidate.cwiseMax(problem.lower).cwiseMin(problem.upper);
  if (isFeasible(problem, candidate.data())) return true;
  candidate = fallback;
  return false;
}

}  // namespace markerless_mocap
