#include <cmath>

#include "hsiao/fit/hsiao_search.h"

namespace markerless_mocap {

using namespace hsiao_stages;

// Hsiao 2008, Table 3-3. The thesis leaves the ranges open, and its stages after the third are
// lost in the scan: here arms, then legs. A torso and a head say nothing of the spin, so it stays
// free until the last stage.
HsiaoFit HsiaoHierarchicalFitter::fitStages(const HsiaoSkeletonError& error,
                                            const HsiaoBounds& allowed, HsiaoVector v,
                                            uint64_t seed) const {
  Parameters parameters, places, angles;
  const auto stage = [&](const Parameters& added, const Active& active, double place_reach) {
    HsiaoBounds range = allowed;
    narrow(range, v, places, place_reach);
    narrow(range, v, kSpin, M_PI);
    narrow(range, v, angles, kAngleReach);
    range.lower = range.lower.cwiseMin(range.upper);
    parameters.insert(parameters.end(), added.begin(), added.end());
    search(error, {parameters, active, range, ++seed}, v);
  };
  const auto addLimbs = [&](const Parameters& added, const Active& active) {
    stage(added, active, kPlaceReach);
    angles.insert(angles.end(), added.begin(), added.end());
  };
  places = kCenter;
  stage(kCenter, kTorsoOnly, kFirstCenterReach);
  places = join({kCenter, kNeck});
  stage(join({kNeck, kSpin}), kTorsoOnly, kFirstNeckReach);
  if (error.has(PartLabel::kHead)) addLimbs(kHead, kTorsoHead);
  if (hasArms(error)) addLimbs(kArms, kTorsoToArms);
  if (hasLegs(error)) addLimbs(kLegs, kAll);
  fineTune(error, allowed, seed + 10, v);
  return {v, errorOf(error, v, kAll)};
}

}  // namespace markerless_mocap
