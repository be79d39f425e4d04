#pragma once

#include <Eigen/Core>
#include <vector>

#include "contour/model/contour_body.h"
#include "contour/fit/contour_fitter.h"

namespace markerless_mocap {

/// One instant that sizes are estimated from.
struct SizeInstant {
  ContourObservation seen;
  ContourPose start;
  /// Where joints are known to be, metres, columns as contourPointNames() (a NaN is not known), or
  /// empty.
  Eigen::Matrix3Xd known_points;
};

/// What is known of a person beforehand.
struct SizePrior {
  ContourTemplate people;
  double stature = 1.72;    ///< metres
  double deviation = 0.08;  ///< of the stature, metres
};

/// Settings of the estimate.
struct SizeEstimateOptions {
  int iterations = 15;
  double outlier_first = 0.06, outlier_last = 0.03;  ///< metres
  double point_deviation = 0.004;                    ///< of known points, metres
};

/// Sizes and poses that explain all instants together.
struct SizeEstimate {
  ContourSizes sizes;
  ContourSizes deviation;  ///< standard deviation of each size; 0 of those that are not estimated
  double stature;          ///< that the template's proportions fit best, metres
  std::vector<ContourPose> poses;  ///< by instant
  int instants_used;               ///< with at least two usable views
};

/// Lengths, radii and poses from some thirty instants of different poses: Gauss-Newton over all
/// together, each instant's pose eliminated by its Schur complement, sizes held to the template of
/// the stature, which is estimated too (Triggs et al., Bundle adjustment, 2000, 6.1). The result
/// does not depend on thread count.
/// \param start sizes to begin with
/// Throws std::invalid_argument if no instant has two usable views, if an observation is of another
/// rig, a start is not finite, known points are of a wrong number, or the options are out of range.
SizeEstimate estimateSizes(const CameraRig& rig, const ContourOptions& contour,
                           const SizePrior& prior, const ContourSizes& start,
                           const std::vector<SizeInstant>& instants,
                           const SizeEstimateOptions& options);

}  // namespace markerless_mocap
