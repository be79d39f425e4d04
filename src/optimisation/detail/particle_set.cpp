#include "optimisation/detail/particle_set.h"

#include <cmath>

#include "optimisation/detail/swarm.h"

namespace markerless_mocap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Number of particles that one task moves and evaluates.
constexpr int kBatch = 8;

}  // namespace

ParticleSet::ParticleSet(const SearchProblem& problem, const SearchStart& start, int particles,
                         const CounterRandom& random)
    : problem_(problem), start_(start.center), costs_(particles) {
  MatrixXd centers = start.center.replicate(1, particles);
  for (Eigen::Index i = 0; i < centers.cols() && start.particles.size() > 0; ++i)
    centers.col(i) = start.particles.col(i % start.particles.cols());
  replace(centers, start.sigma.asDiagonal(), random);
}

MatrixXd ParticleSet::drawn(const VectorXd& weights, const CounterRandom& random) const {
  MatrixXd next(positions_.rows(), positions_.cols());
  for (Eigen::Index i = 0; i < next.cols(); ++i)
    next.col(i) = positions_.col(drawIndex(weights, random.uniform(uint64_t(i))));
  return next;
}

void ParticleSet::replace(const MatrixXd& centers, const MatrixXd& root,
                          const CounterRandom& random) {
  const auto dimensions = centers.rows();
  MatrixXd next(dimensions, centers.cols());
  Eigen::VectorXi rejected_moves = Eigen::VectorXi::Zero(centers.cols());
  const auto place = [&](int i) {
    const CounterRandom own = random.stream(uint64_t(i));
    VectorXd noise(dimensions);
    const VectorXd center = centers.col(i);
    rejected_moves[i] = !drawFeasible(
        problem_, center,
        [&](int attempt, Eigen::Ref<VectorXd> candidate) {
          for (Eigen::Index d = 0; d < dimensions; ++d)
            noise[d] = own.normal(uint64_t(attempt * dimensions + d));
          candidate.noalias() = center + root * noise;
        },
        next.col(i));
  };
  evaluateInBatches(problem_, 0, kBatch, place, next, costs_);
  positions_ = std::move(next);
  evaluations_ += int(centers.cols());
  rejected_moves_ += rejected_moves.sum();
}

SearchOutcome ParticleSet::outcome(const VectorXd& weights) const {
  SearchOutcome result;
  result.evaluations = evaluations_;
  result.rejected_moves = rejected_moves_;
  result.best = start_;
  result.cost = HUGE_VAL;
  result.found = costs_.array().isFinite().any();
  if (!result.found) return result;
  result.best = positions_ * weights;
  result.cost = 0.0;
  for (Eigen::Index i = 0; i < weights.size(); ++i)
    if (weights[i] > 0.0) result.cost += weights[i] * costs_[i];
  return result;
}

int drawIndex(const VectorXd& weights, double u) {
  double left = u * weights.sum();
  for (Eigen::Index i = 0; i + 1 < weights.size(); ++i) {
    left -= weights[i];
    if (left < 0.0) return int(i);
  }
  return int(weights.size() - 1);
}

VectorXd spreadOf(const MatrixXd& positions) {
  const MatrixXd centered = positions.colwise() - positions.rowwise().mean();
  return (centered.rowwise().squaredNorm() / double(positions.cols())).cwiseSqrt();
}

}  // namespace markerless_mocap
