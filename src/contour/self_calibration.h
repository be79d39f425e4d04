#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contour/fit/contour_fitter.h"
#include "contour/model/contour_body.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {

/// One frame for the refinement of the camera orientations.
struct OrientationSample {
  ContourObservation seen;  ///< with the rig that is to be corrected
  ContourPose start;
};

/// Rotation of one camera relative to its calibration.
struct OrientationCorrection {
  std::string camera;
  /// Shift of the image centre when the correction is applied, right and down, pixels.
  Eigen::Vector2d pixels = Eigen::Vector2d::Zero();
  /// Standard deviation of both: from the scatter of the frames, and from the difference between
  /// their first and second half. It does not include errors of the body shape, which are the same
  /// in all frames.
  Eigen::Vector2d deviation = Eigen::Vector2d::Zero();
  double turn = 0.0;  ///< of the camera, radians
  size_t rays = 0;    ///< number of explained rays that the estimate is based on
  /// One line of text for the user: the camera and its correction.
  std::string summary() const;
};

/// Agreement of body and silhouettes, mean over the frames.
struct OrientationFit {
  double overlap = 0.0;   ///< ContourFit::overlap, 0 to 1
  double distance = 0.0;  ///< root mean square distance of the rays from the body, with a robust
                          ///< loss, metres
};

/// kCorrected: the rig is better with the corrections. kNoGain: the rig is not significantly
/// better. kTooFewSamples: less than four frames could be fitted.
enum class OrientationRefinementStatus { kCorrected, kNoGain, kTooFewSamples };
const char* toString(OrientationRefinementStatus status);

struct OrientationRefinement {
  OrientationRefinementStatus status = OrientationRefinementStatus::kTooFewSamples;
  CameraRig rig;                                   ///< rotated cameras if corrected, else as given
  std::vector<OrientationCorrection> corrections;  ///< per camera; estimated even if not applied
  OrientationFit before;                           ///< with the given rig
  /// By cross-validation: each half of the frames is fitted with the corrections that the other
  /// half gives.
  OrientationFit after;
  double significance = 0.0;       ///< of the decrease in distance: mean divided by standard error
  std::vector<ContourPose> poses;  ///< per frame, with `rig`
  int samples_used = 0;            ///< frames with at least two usable views and a successful fit
  /// One line of text for the user: the result and the decision.
  std::string summary() const;
};

/// Estimates two small rotations of each camera, about its vertical and horizontal axis, so that
/// the contours of some thirty frames agree with one body: Gauss-Newton over all frames; the pose
/// of each frame is eliminated by its Schur complement (Triggs et al., Bundle adjustment, 2000,
/// 6.1). Camera positions, roll, intrinsics and the body are assumed to be correct. The corrected
/// rig is returned only if cross-validation shows a significant gain, else the rig is unchanged. A
/// rotation that all cameras have in common looks almost like another position of the person. Only
/// perspective distinguishes the two, so it is determined less well than the relative orientations.
/// The frames should therefore show many postures and positions. The result does not depend on the
/// number of threads. Throws std::invalid_argument if an observation is of another rig or a start
/// pose is not finite.
OrientationRefinement refineCameraOrientations(const CameraRig& rig, const ContourOptions& contour,
                                               const ContourBody& body,
                                               const std::vector<OrientationSample>& samples);

/// Alternates refineCameraOrientations() and estimateShape(), because a shape that was estimated
/// with wrong orientations hides a part of their error. If the first refinement gives no gain, its
/// result is returned.
/// \param prior, shape of the person; the shape as estimated with the given rig
/// Throws std::invalid_argument as these two functions.
OrientationRefinement refineOrientationsAndShape(const CameraRig& rig,
                                                 const ContourOptions& contour,
                                                 const ShapePrior& prior,
                                                 const ShapeParameters& shape,
                                                 const std::vector<OrientationSample>& samples);

}  // namespace markerless_mocap
