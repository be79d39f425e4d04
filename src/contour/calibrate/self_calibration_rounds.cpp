#include <utility>

#include "contour/calibrate/self_calibration_equations.h"
#include "contour/self_calibration.h"

namespace markerless_mocap {
namespace {

// In a further round, the orientations would change by less than a tenth of a pixel.
constexpr int kRounds = 3;

ShapeParameters reestimatedShape(const CameraRig& rig, const ContourOptions& contour,
                                 const ShapePrior& prior, const ShapeParameters& shape,
                                 const std::vector<OrientationSample>& samples,
                                 const OrientationRefinement& refinement) {
  std::vector<ShapeSample> seen;
  for (size_t i = 0; i < samples.size(); ++i)
    seen.push_back(
        {rotatedObservation(samples[i].seen, rig, refinement.rig), refinement.poses[i], {}});
  return estimateShape(refinement.rig, contour, prior, shape, seen).shape;
}

}  // namespace

OrientationRefinement refineOrientationsAndShape(const CameraRig& rig,
                                                 const ContourOptions& contour,
                                                 const ShapePrior& prior,
                                                 const ShapeParameters& shape,
                                                 const std::vector<OrientationSample>& samples) {
  OrientationRefinement best = refineCameraOrientations(rig, contour, ContourBody(shape), samples);
  const OrientationFit before = best.before;
  ShapeParameters estimated = shape;
  for (int round = 1; round < kRounds && best.status == OrientationRefinementStatus::kCorrected;
       ++round) {
    estimated = reestimatedShape(rig, contour, prior, estimated, samples, best);
    std::vector<OrientationSample> again = samples;
    for (size_t i = 0; i < again.size(); ++i) again[i].start = best.poses[i];
    OrientationRefinement next =
        refineCameraOrientations(rig, contour, ContourBody(estimated), again);
    if (next.status != OrientationRefinementStatus::kCorrected) break;
    best = std::move(next);
  }
  best.before = before;  // with the initial shape
  return best;
}

}  // namespace markerless_mocap
