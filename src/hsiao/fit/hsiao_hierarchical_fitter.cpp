#include "hsiao/fit/hsiao_hierarchical_fitter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "hsiao/fit/hsiao_search.h"
#include "optimisation/inertia_swarm.h"

namespace markerless_mocap {

using namespace hsiao_stages;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double kTuneReach = 0.4;  // of a joint angle, rad

}  // namespace

HsiaoHierarchicalFitter::HsiaoHierarchicalFitter(const HsiaoBodyModel& body_model,
                                                 const HsiaoFitterSettings& settings)
    : body_model_(&body_model), settings_(settings) {}

HsiaoBounds HsiaoHierarchicalFitter::limits() const {
  HsiaoBounds range;
  const double inf = std::numeric_limits<double>::infinity();
  range.lower.setConstant(-inf);
  range.upper.setConstant(inf);
  for (int k = 1; k <= kHsiaoAngles; ++k) {
    range.lower[hsiaoTheta(k)] = settings_.limits.lower[k - 1];
    range.upper[hsiaoTheta(k)] = settings_.limits.upper[k - 1];
  }
  return range;
}

double HsiaoHierarchicalFitter::errorOf(const HsiaoSkeletonError& error, const HsiaoVector& v,
                                        const Active& active) const {
  HsiaoFrames frames;
  body_model_->frames(v.data(), frames);
  return error(frames, active);
}

void HsiaoHierarchicalFitter::search(const HsiaoSkeletonError& error, const Search& what,
                                     HsiaoVector& v) const {
  const int n = int(what.parameters.size());
  const auto pick = [&](const HsiaoVector& all) {
    VectorXd some(n);
    for (int i = 0; i < n; ++i) some[i] = all[what.parameters[i]];
    return some;
  };
  SearchProblem problem;
  problem.lower = pick(what.range.lower);
  problem.upper = pick(what.range.upper);
  problem.cost = [&](int, const double* candidates, int count, double* costs) {
    HsiaoVector candidate = v;
    for (int c = 0; c < count; ++c) {
      for (int i = 0; i < n; ++i) candidate[what.parameters[i]] = candidates[c * n + i];
      costs[c] = errorOf(error, candidate, what.active);
    }
  };
  std::vector<VectorXd> starts = {pick(v)};
  for (const HsiaoVector& guess : what.guesses) starts.push_back(pick(guess));
  InertiaSwarmSettings settings;
  settings.particles = what.is_fine_tuning ? settings_.fine_tune_particles
                                           : int(std::ceil(settings_.particles_per_parameter * n));
  settings.iterations = what.is_fine_tuning
                            ? settings_.fine_tune_iterations
                            : int(std::ceil(settings_.iterations_per_parameter * n));
  settings.inertia = settings_.inertia;
  settings.cognitive_weight = settings_.cognitive_weight;
  settings.social_weight = settings_.social_weight;
  const SearchOutcome found = InertiaSwarm(settings).minimise(problem, starts, what.seed);
  for (int i = 0; i < n; ++i) v[what.parameters[i]] = found.best[i];
  const Vector3d center = v.segment<3>(kHsiaoCenter);
  v.segment<3>(kHsiaoNeck) =
      center + body_model_->halfTorso() * (v.segment<3>(kHsiaoNeck) - center).normalized();
}

std::vector<HsiaoFit> HsiaoHierarchicalFitter::fitBasic(const HsiaoSkeletonError& error,
                                                        const HsiaoVector& rest,
                                                        uint64_t seed) const {
  const std::vector<Vector3d>& torso = error.samples(PartLabel::kTorso);
  HsiaoVector v = rest;
  v.segment<3>(kHsiaoCenter) = 0.5 * (torso.front() + torso.back());
  v.segment<3>(kHsiaoNeck) = v.segment<3>(kHsiaoCenter) +
                             body_model_->halfTorso() * (torso.back() - torso.front()).normalized();
  if (settings_.as_published) return {fitStages(error, limits(), v, seed)};
  return fitHeadings(error, v, seed);
}

HsiaoFit HsiaoHierarchicalFitter::fitTemporal(const HsiaoSkeletonError& error,
                                              const HsiaoVector& last, const HsiaoVector& reach,
                                              std::vector<HsiaoVector> guesses,
                                              uint64_t seed) const {
  HsiaoBounds range = limits();
  range.lower = range.lower.cwiseMax(last - reach).cwiseMin(range.upper);
  range.upper = range.upper.cwiseMin(last + reach).cwiseMax(range.lower);
  if (settings_.as_published) return fitStages(error, range, last, seed);
  return follow(error, range, last, std::move(guesses), seed);
}

void HsiaoHierarchicalFitter::fineTune(const HsiaoSkeletonError& error, const HsiaoBounds& range,
                                       uint64_t seed, HsiaoVector& v) const {
  const auto tunePart = [&](const Parameters& parameters, const Active& active, double reach) {
    HsiaoBounds near = range;
    narrow(near, v, parameters, reach);
    near.lower = near.lower.cwiseMin(near.upper);
    search(error, {parameters, active, near, ++seed, true}, v);
  };
  tunePart(kCenter, kAll, kPlaceReach);
  tunePart(join({kNeck, kSpin}), kAll, kPlaceReach);
  if (error.has(PartLabel::kHead)) tunePart(kHead, kHeadOnly, kTuneReach);
  for (int side = 0; side < 2; ++side) {
    if (hasArms(error)) tunePart(kArm[side], kArmsOnly, kTuneReach);
    if (hasLegs(error)) tunePart(kLeg[side], kLegsOnly, kTuneReach);
  }
}

}  // namespace markerless_mocap
