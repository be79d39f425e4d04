#include "hsiao/fit/hsiao_hierarchical_fitter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "hsiao/fit/hsiao_arm_initialization.h"
#include "optimisation/inertia_swarm.h"

namespace markerless_mocap {
namespace {

using Active = std::array<bool, kPartCount>;
using Parameters = std::vector<int>;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Parameters kCenter = {0, 1, 2};
const Parameters kNeck = {3, 4, 5};
const Parameters kSpin = {6};
const Parameters kHead = {7, 8};
const Parameters kArms = {9, 10, 11, 12, 13, 14, 15, 16};
const Parameters kLegs = {17, 18, 19, 20, 21, 22};
const std::array<Parameters, 2> kArm = {Parameters{9, 11, 13, 15}, Parameters{10, 12, 14, 16}};
const std::array<Parameters, 2> kLeg = {Parameters{17, 19, 21}, Parameters{18, 20, 22}};

const Active kTorsoOnly = {true};
const Active kTorsoHead = {true, true};
const Active kTorsoToArms = {true, true, true, true};
const Active kAll = {true, true, true, true, true, true};
const Active kHeadOnly = {false, true};
const Active kArmsOnly = {false, false, true, true};
const Active kLegsOnly = {false, false, false, false, true, true};

// Search range of a stage around the values that earlier stages found: metres, radians.
constexpr double kFirstCenterReach = 0.2;
constexpr double kFirstNeckReach = 0.25;
constexpr double kPlaceReach = 0.1;
constexpr double kAngleReach = 0.6;
constexpr double kTuneReach = 0.4;
// Range of the spin, as a fraction of the angle to the neighbouring heading.
constexpr double kSpinFraction = 0.7;

Parameters join(std::initializer_list<Parameters> groups) {
  Parameters all;
  for (const Parameters& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

bool hasArms(const HsiaoSkeletonError& e) {
  return e.has(PartLabel::kArm1) || e.has(PartLabel::kArm2);
}
bool hasLegs(const HsiaoSkeletonError& e) {
  return e.has(PartLabel::kLeg1) || e.has(PartLabel::kLeg2);
}

void narrow(HsiaoBounds& range, const HsiaoVector& v, const Parameters& parameters, double reach) {
  for (const int p : parameters) {
    range.lower[p] = std::max(range.lower[p], v[p] - reach);
    range.upper[p] = std::min(range.upper[p], v[p] + reach);
  }
}

// Spin of a body whose left side is determined by the roots of the limbs; the opposite one is
// equally possible.
double sidewaysSpin(const HsiaoSkeletonError& error) {
  Vector3d left = Vector3d::Zero();
  for (const auto& [one, other] : {std::pair(PartLabel::kArm1, PartLabel::kArm2),
                                   std::pair(PartLabel::kLeg1, PartLabel::kLeg2)}) {
    if (!error.has(one) || !error.has(other)) continue;
    const Vector3d way = error.samples(one).front() - error.samples(other).front();
    left += left.dot(way) < 0 ? Vector3d(-way) : way;
  }
  return std::atan2(-left.x(), left.y());
}

}  // namespace

struct HsiaoHierarchicalFitter::Search {
  Parameters parameters;
  Active active;
  HsiaoBounds range;
  uint64_t seed;
  bool is_fine_tuning = false;            // of a size of its own, whatever the parameters
  std::vector<HsiaoVector> guesses = {};  // in addition to the current vector
};

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
  const auto stage = [&](const Parameters& parameters, const HsiaoBounds& range) {
    search(error, {parameters, kTorsoOnly, range, seed}, v);
  };
  HsiaoBounds range = limits();
  narrow(range, v, kCenter, kFirstCenterReach);
  stage(kCenter, range);
  range = limits();
  narrow(range, v, kCenter, kPlaceReach);
  narrow(range, v, kNeck, kFirstNeckReach);
  stage(join({kCenter, kNeck}), range);
  std::vector<HsiaoFit> fits;
  const double spin = sidewaysSpin(error);
  for (int k = 0; k < settings_.initial_headings; ++k) {
    v[kHsiaoSpin] = spin + 2 * M_PI * k / settings_.initial_headings;
    fits.push_back(fitFromHeading(error, v, seed + 100 * (k + 1)));
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const HsiaoFit& a, const HsiaoFit& b) { return a.error_m < b.error_m; });
  return fits;
}

HsiaoFit HsiaoHierarchicalFitter::fitFromHeading(const HsiaoSkeletonError& error, HsiaoVector v,
                                                 uint64_t seed) const {
  Parameters parameters = join({kCenter, kNeck, kSpin});
  const Parameters spun = kSpin;
  Parameters found;
  const auto stage = [&](const Parameters& added, const Active& active) {
    HsiaoBounds range = limits();
    narrow(range, v, join({kCenter, kNeck}), kPlaceReach);
    narrow(range, v, spun, kSpinFraction * M_PI / settings_.initial_headings);
    narrow(range, v, found, kAngleReach);
    parameters.insert(parameters.end(), added.begin(), added.end());
    search(error, {parameters, active, range, ++seed}, v);
    found.insert(found.end(), added.begin(), added.end());
  };
  if (error.has(PartLabel::kHead)) stage(kHead, kTorsoHead);
  if (hasArms(error)) {
    for (int side = 0; side < 2; ++side)
      initializeArm(error, *body_model_, settings_.limits, side, v);
    initializeLimbs(error, PartLabel::kArm1, kArm, seed + 20, v);
    stage(kArms, kTorsoToArms);
  }
  if (hasLegs(error)) {
    initializeLimbs(error, PartLabel::kLeg1, kLeg, seed + 30, v);
    stage(kLegs, kAll);
  }
  fineTune(error, limits(), seed + 10, v);
  return {v, errorOf(error, v, kAll)};
}

void HsiaoHierarchicalFitter::initializeLimbs(const HsiaoSkeletonError& error, PartLabel first,
                                              const std::array<Parameters, 2>& limbs, uint64_t seed,
                                              HsiaoVector& v) const {
  HsiaoFrames frames;
  body_model_->frames(v.data(), frames);
  for (int side = 0; side < 2; ++side) {
    Active active{};
    active[size_t(limbOfSide(error, *body_model_, frames, first, side))] = true;
    search(error, {limbs[side], active, limits(), seed + side, true}, v);
  }
}

HsiaoFit HsiaoHierarchicalFitter::fitTemporal(const HsiaoSkeletonError& error,
                                              const HsiaoVector& last, const HsiaoVector& reach,
                                              std::vector<HsiaoVector> guesses,
                                              uint64_t seed) const {
  Parameters parameters = join({kCenter, kNeck, kSpin});
  const auto add = [&parameters](const Parameters& more) {
    parameters.insert(parameters.end(), more.begin(), more.end());
  };
  if (error.has(PartLabel::kHead)) add(kHead);
  if (hasArms(error)) add(kArms);
  if (hasLegs(error)) add(kLegs);
  HsiaoBounds range = limits();
  range.lower = range.lower.cwiseMax(last - reach).cwiseMin(range.upper);
  range.upper = range.upper.cwiseMin(last + reach).cwiseMax(range.lower);
  HsiaoVector v = last;
  HsiaoVector guess = last;
  if (hasArms(error))
    for (int side = 0; side < 2; ++side)
      initializeArm(error, *body_model_, settings_.limits, side, guess);
  guesses.push_back(guess);
  search(error, {parameters, kAll, range, seed, false, guesses}, v);
  fineTune(error, range, seed + 10, v);
  return {v, errorOf(error, v, kAll)};
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
