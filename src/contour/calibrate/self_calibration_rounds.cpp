#include <utility>

#include "contour/calibrate/self_calibration_equations.h"
#include "contour/self_calibration.h"

namespace markerless_mocap {
namespace {

// After them the pointing moves by less than a tenth of a pixel.
constexpr int kRounds = 3;

ContourSizes measuredAgain(const CameraRig& rig, const ContourOptions& contour,
                           const SizePrior& prior, const ContourSizes& sizes,
                           const std::vector<PointingInstant>& instants,
                           const PointingEstimate& pointing) {
  std::vector<SizeInstant> seen;
  for (size_t i = 0; i < instants.size(); ++i)
    seen.push_back({turnedObservation(instants[i].seen, rig, pointing.rig), pointing.poses[i], {}});
  return estimateSizes(pointing.rig, contour, prior, sizes, seen, {}).sizes;
}

}  // namespace

PointingEstimate estimatePointingAndSizes(const CameraRig& rig, const ContourOptions& contour,
                                          const SizePrior& prior, const ContourSizes& sizes,
                                          const std::vector<PointingInstant>& instants,
                                          const PointingOptions& options) {
  PointingEstimate best = estimatePointing(rig, contour, ContourBody(sizes), instants, options);
  const PointingFit before = best.before;
  ContourSizes measured = sizes;
  for (int round = 1; round < kRounds && best.status == PointingStatus::kCorrected; ++round) {
    measured = measuredAgain(rig, contour, prior, measured, instants, best);
    std::vector<PointingInstant> again = instants;
    for (size_t i = 0; i < again.size(); ++i) again[i].start = best.poses[i];
    PointingEstimate next = estimatePointing(rig, contour, ContourBody(measured), again, options);
    if (next.status != PointingStatus::kCorrected) break;
    best = std::move(next);
  }
  best.before = before;  // with the body as measured by the rig as given
  return best;
}

}  // namespace markerless_mocap
