#include <algorithm>
#include <cmath>

#include "hsiao/fit/hsiao_arm_initialization.h"
#include "hsiao/fit/hsiao_search.h"

namespace markerless_mocap {

using namespace hsiao_stages;
using Eigen::Vector3d;

namespace {

// Range of the spin, as a fraction of the angle to the neighbouring heading.
constexpr double kSpinFraction = 0.7;

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

std::vector<HsiaoFit> HsiaoHierarchicalFitter::fitHeadings(const HsiaoSkeletonError& error,
                                                           HsiaoVector v, uint64_t seed) const {
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
    fits.push_back(fitFromHeading(error, v, seed + uint64_t(100) * (k + 1)));
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

HsiaoFit HsiaoHierarchicalFitter::follow(const HsiaoSkeletonError& error, const HsiaoBounds& range,
                                         HsiaoVector v, std::vector<HsiaoVector> guesses,
                                         uint64_t seed) const {
  Parameters parameters = join({kCenter, kNeck, kSpin});
  const auto add = [&parameters](const Parameters& more) {
    parameters.insert(parameters.end(), more.begin(), more.end());
  };
  if (error.has(PartLabel::kHead)) add(kHead);
  if (hasArms(error)) add(kArms);
  if (hasLegs(error)) add(kLegs);
  HsiaoVector guess = v;
  if (hasArms(error))
    for (int side = 0; side < 2; ++side)
      initializeArm(error, *body_model_, settings_.limits, side, guess);
  guesses.push_back(guess);
  search(error, {parameters, kAll, range, seed, false, guesses}, v);
  fineTune(error, range, seed + 10, v);
  return {v, errorOf(error, v, kAll)};
}

}  // namespace markerless_mocap
