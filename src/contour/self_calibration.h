#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contour/fit/contour_fitter.h"
#include "contour/model/contour_body.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {

/// One instant that the cameras' pointing is estimated from.
struct OrientationSample {
  ContourObservation seen;  ///< by the rig that is to be corrected
  ContourPose start;
};

/// Settings of the estimate.
struct OrientationRefinementOptions {
  int iterations = 12;
  double robust_scale_initial = 0.08, robust_scale_final = 0.03;  ///< metres
  /// Standard deviation of the pointing as given, pixels: what contours do not tell stays as it is.
  double sigma_px = 2.0;
  /// A gain counts when it is this many times its standard error over the instants, and when the
  /// rays' distance from the body falls by this share at least.
  double min_significance = 4.0;
  double least_gain = 0.03;
};

/// How one camera points otherwise than its calibration says.
struct OrientationCorrection {
  std::string camera;
  /// By which the image of a point in the middle of the image moves when the correction is applied,
  /// right and down, pixels.
  Eigen::Vector2d pixels = Eigen::Vector2d::Zero();
  /// Standard deviation of both: by the scatter of the instants and by what their first and second
  /// half differ in. An error that the body's sizes make in all instants alike is not in it.
  Eigen::Vector2d deviation = Eigen::Vector2d::Zero();
  double turn = 0.0;  ///< of the camera, radians
  size_t rays = 0;    ///< explained ones that it is from
  /// One sentence for people: which camera, by how much.
  std::string sentence() const;
};

/// How well body and silhouettes go together, mean over the instants.
struct OrientationFit {
  double overlap = 0.0;   ///< ContourFit::overlap, 0 to 1
  double distance = 0.0;  ///< of the rays from the body, root mean square, limited, metres
};

/// kCorrected: the rig is better with the corrections. kNoGain: it is not, or not surely.
/// kTooFewSamples: less than four instants could be fitted.
enum class OrientationRefinementStatus { kCorrected, kNoGain, kTooFewSamples };
const char* toString(OrientationRefinementStatus status);

struct OrientationRefinement {
  OrientationRefinementStatus status = OrientationRefinementStatus::kTooFewSamples;
  CameraRig rig;                                   ///< turned cameras if corrected, else as given
  std::vector<OrientationCorrection> corrections;  ///< by camera, as estimated even if not applied
  OrientationFit before;                           ///< with the rig as given
  /// Of instants that had no part in the estimate: each half of them judges the other half's.
  OrientationFit after;
  double significance = 0.0;       ///< of the gain in distance: mean by standard error
  std::vector<ContourPose> poses;  ///< by instant, with `rig`
  int samples_used = 0;            ///< with at least two usable views and a fit
  /// One sentence for people: what was found and done.
  std::string sentence() const;
};

/// Two small rotations of each camera, to the side and up and down, that make the contours of some
/// thirty instants and one body agree: Gauss-Newton over all together, each instant's pose
/// eliminated by its Schur complement (Triggs et al., Bundle adjustment, 2000, 6.1). Cameras'
/// places, roll and lenses are taken to be right, and so is the body. The estimate is handed out
/// as a corrected rig only if it serves the instants it is not from; else the rig comes back as
/// it is. A shift of all cameras that is as if the person stood elsewhere is told by perspective
/// alone, so less well than how cameras point relative to each other: instants should be of many
/// postures and places. The result does not depend on thread
/// count.
/// Throws std::invalid_argument if an observation is of another rig, a start is not finite, or the
/// options are out of range.
OrientationRefinement refineCameraOrientations(const CameraRig& rig, const ContourOptions& contour,
                                               const ContourBody& body,
                                               const std::vector<OrientationSample>& instants,
                                               const OrientationRefinementOptions& options);

/// refineCameraOrientations() and estimateShape() in turn, as sizes that were measured with cameras
/// that point elsewhere hide a part of it. Without a gain by the sizes as given, these are all that
/// was tried. \param prior, sizes of the person; sizes as measured with the rig as given Throws
/// std::invalid_argument as these two.
OrientationRefinement refineOrientationsAndShape(const CameraRig& rig,
                                                 const ContourOptions& contour,
                                                 const ShapePrior& prior,
                                                 const ShapeParameters& sizes,
                                                 const std::vector<OrientationSample>& instants,
                                                 const OrientationRefinementOptions& options);

}  // namespace markerless_mocap
