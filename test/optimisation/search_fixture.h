#pragma once

#include <cmath>
#include <mutex>
#include <vector>

#include "optimisation/optimiser.h"

namespace markerless_mocap {

inline SearchProblem unbounded(int dimensions, std::function<double(const double*)> cost) {
  SearchProblem problem;
  problem.lower = Eigen::VectorXd::Constant(dimensions, -HUGE_VAL);
  problem.upper = Eigen::VectorXd::Constant(dimensions, HUGE_VAL);
  problem.cost = [dimensions, cost](int, const double* candidates, int count, double* costs) {
    for (int i = 0; i < count; ++i) costs[i] = cost(candidates + i * dimensions);
  };
  return problem;
}

/// Squared distance to (1, 2, 3, ...) / 10.
inline std::function<double(const double*)> bowl(int dimensions) {
  return [dimensions](const double* x) {
    double sum = 0.0;
    for (int d = 0; d < dimensions; ++d) sum += std::pow(x[d] - 0.1 * (d + 1), 2);
    return sum;
  };
}

/// Two dimensions with a local minimum near every whole pair about 0, 0, which is the lowest.
inline double hollows(const double* x) {
  double sum = 0.0;
  for (int d = 0; d < 2; ++d) sum += x[d] * x[d] + 2.0 * (1.0 - std::cos(2.0 * M_PI * x[d]));
  return sum;
}

inline SearchStart around(int dimensions, double center, double sigma) {
  return {Eigen::VectorXd::Constant(dimensions, center),
          Eigen::VectorXd::Constant(dimensions, sigma)};
}

/// Keeps all candidates that a search asks about, in order when it has one thread.
struct Witness {
  std::mutex mutex;
  std::vector<Eigen::VectorXd> candidates;

  void attend(SearchProblem* problem) {
    const auto inner = problem->cost;
    const auto dimensions = problem->lower.size();
    problem->cost = [this, inner, dimensions](int stage, const double* x, int count,
                                              double* costs) {
      inner(stage, x, count, costs);
      const std::lock_guard<std::mutex> lock(mutex);
      for (int i = 0; i < count; ++i)
        candidates.push_back(Eigen::Map<const Eigen::VectorXd>(x + i * dimensions, dimensions));
    };
  }
};

}  // namespace markerless_mocap
