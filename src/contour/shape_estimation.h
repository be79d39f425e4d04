#pragma once

#include <Eigen/Core>
#include <vector>

#include "contour/fit/contour_fitter.h"
#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// One frame for the shape estimate.
struct ShapeSample {
  ContourObservation seen;
  ContourPose start;
  /// Known joint positions, metres, 3 x number of contourPointNames() (NaN if unknown), or empty.
  Eigen::Matrix3Xd known_points;
};

/// Prior knowledge of a person.
struct ShapePrior {
  ShapeStatistics shape_statistics;
  double stature = 1.72;    ///< metres
  double deviation = 0.08;  ///< standard deviation of the stature, metres
};

/// Shape and poses that fit all frames.
struct ShapeEstimate {
  ShapeParameters shape;
  ShapeParameters deviation;  ///< standard deviation of each parameter; 0 if it is not estimated
  double stature;             ///< for which the mean shape fits best, metres
  std::vector<ContourPose> poses;  ///< per frame
  int samples_used;                ///< frames with at least two usable views
};

/// Estimates lengths, radii, offsets and poses from some thirty frames of different poses:
/// Gauss-Newton over all frames; the pose of each frame is eliminated by its Schur complement
/// (Triggs et al., Bundle adjustment, 2000, 6.1). The prior of the shape depends on the stature,
/// which is estimated, too. The result does not depend on the number of threads.
/// \param start initial shape
/// Throws std::invalid_argument if no frame has two usable views, if an observation is of another
/// rig, if a start pose is not finite, if the number of known points is wrong, or if the prior's
/// stature or deviation is not positive.
ShapeEstimate estimateShape(const CameraRig& rig, const ContourOptions& contour,
                            const ShapePrior& prior, const ShapeParameters& start,
                            const std::vector<ShapeSample>& samples);

}  // namespace markerless_mocap
