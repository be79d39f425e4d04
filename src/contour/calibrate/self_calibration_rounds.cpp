#include <utility>

#include "contour/calibrate/self_calibration_equations.h"
#include "contour/self_calibration.h"

namespace markerless_mocap {
namespace {

// After them the pointing moves by less than a tenth of a pixel.
constexpr int kRounds = 3;

ShapeParameters measuredAgain(const CameraRig& rig, const ContourOptions& contour,
                              const ShapePrior& prior, const ShapeParameters& sizes,
                              const std::vector<OrientationSample>& instants,
                              const OrientationRefinement& pointing) {
  std::vector<ShapeSample> seen;
  for (size_t i = 0; i < instants.size(); ++i)
    seen.push_back(
        {rotatedObservation(instants[i].seen, rig, pointing.rig), pointing.poses[i], {}});
  return estimateShape(pointing.rig, contour, prior, sizes, seen, {}).sizes;
}

}  // namespace

OrientationRefinement refineOrientationsAndShape(const CameraRig& rig,
                                                 const ContourOptions& contour,
                                                 const ShapePrior& prior,
                                                 const ShapeParameters& sizes,
                                                 const std::vector<OrientationSample>& instants,
                                                 const OrientationRefinementOptions& options) {
  OrientationRefinement best =
      refineCameraOrientations(rig, contour, ContourBody(sizes), instants, options);
  const OrientationFit before = best.before;
  ShapeParameters measured = sizes;
  for (int round = 1; round < kRounds && best.status == OrientationRefinementStatus::kCorrected;
       ++round) {
    measured = measuredAgain(rig, contour, prior, measured, instants, best);
    std::vector<OrientationSample> again = instants;
    for (size_t i = 0; i < again.size(); ++i) again[i].start = best.poses[i];
    OrientationRefinement next =
        refineCameraOrientations(rig, contour, ContourBody(measured), again, options);
    if (next.status != OrientationRefinementStatus::kCorrected) break;
    best = std::move(next);
  }
  best.before = before;  // with the body as measured by the rig as given
  return best;
}

}  // namespace markerless_mocap
