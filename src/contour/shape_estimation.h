#pragma once

#include <Eigen/Core>
#include <vector>

#include "contour/fit/contour_fitter.h"
#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// One instant that sizes are estimated from.
struct ShapeSample {
  ContourObservation seen;
  ContourPose start;
  /// Where joints are known to be, metres, columns as contourPointNames() (a NaN is not known), or
  /// empty.
  Eigen::Matrix3Xd known_points;
};

/// What is known of a person beforehand.
struct ShapePrior {
  ShapeStatistics people;
  double stature = 1.72;    ///< metres
  double deviation = 0.08;  ///< of the stature, metres
};

/// Settings of the estimate.
struct ShapeEstimationOptions {
  int iterations = 15;
  double robust_scale_initial = 0.06, robust_scale_final = 0.03;  ///< metres
  double point_deviation = 0.004;                                 ///< of known points, metres
};

/// Sizes and poses that explain all instants together.
struct ShapeEstimate {
  ShapeParameters sizes;
  ShapeParameters
      deviation;   ///< standard deviation of each size; 0 of those that are not estimated
  double stature;  ///< that the template's proportions fit best, metres
  std::vector<ContourPose> poses;  ///< by instant
  int samples_used;                ///< with at least two usable views
};

/// Lengths, radii and poses from some thirty instants of different poses: Gauss-Newton over all
/// together, each instant's pose eliminated by its Schur complement, sizes held to the template of
/// the stature, which is estimated too (Triggs et al., Bundle adjustment, 2000, 6.1). The result
/// does not depend on thread count.
/// \param start sizes to begin with
/// Throws std::invalid_argument if no instant has two usable views, if an observation is of another
/// rig, a start is not finite, known points are of a wrong number, or the options are out of range.
ShapeEstimate estimateShape(const CameraRig& rig, const ContourOptions& contour,
                            const ShapePrior& prior, const ShapeParameters& start,
                            const std::vector<ShapeSample>& instants,
                            const ShapeEstimationOptions& options);

}  // namespace markerless_mocap
