#pragma once

#include <array>
#include <optional>

#include "contour/fit/contour_observation.h"
#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// Where the body is expected from its motion.
struct ContourPrediction {
  ContourPose pose;
  double seconds = 0.0;  ///< since the instant it was predicted from, more than 0
};

/// The pose that goes on from the last one as fast as before. \param share of the last velocity
/// that is kept, 0 to 1
ContourPose predictConstantVelocity(const ContourPose& before, const ContourPose& last,
                                    double share);

/// How many steps and from which distance on a ray is mostly ignored: less in every step.
struct RobustSchedule {
  int iterations;
  double robust_scale_initial, robust_scale_final;  ///< metres

  /// For a start that may be off by tenths of a radian and decimetres.
  static RobustSchedule wide() { return {24, 0.3, 0.03}; }
};

/// What speaks for a limb where it is.
struct LimbEvidence {
  int rays = 0;           ///< that touch it, within kRayExplained
  double distance = 0.0;  ///< of these rays from its surface, root mean square, metres
  double outside = 0.0;   ///< by which it sticks out of masks, mean over its balls, metres
  /// Expected error of its end (head, wrist, ankle; trunk: neck's base), metres: what contours and
  /// posture leave open. Rays count by how well rays and masks agree with their limb, those of an
  /// arm by how much worse the rest of the body would explain them; prediction and masks that are
  /// merely not left count nothing.
  double deviation = 0.0;
};

/// A ray nearer to the body than this is explained, metres.
constexpr double kRayExplained = 0.03;

/// kTooFewViews: less than two masks can be used. kDiverged: no finite pose came out.
enum class ContourFitStatus { kFitted, kTooFewViews, kDiverged };
const char* toString(ContourFitStatus status);

/// Meaningful beyond the status only when that is kFitted.
struct ContourFit {
  ContourFitStatus status = ContourFitStatus::kTooFewViews;
  ContourPose pose;
  /// How well body and masks cover each other, mean over the usable views: half the share of the
  /// body that is in the mask plus half the share of the mask that is in the body (Fleischmann
  /// 2012, 5.2.1), 0 to 1.
  double overlap = 0.0;
  double rays_explained = 0.0;  ///< share of the rays nearer than kRayExplained, 0 to 1
  std::array<LimbEvidence, ContourLimb::kCount> limbs{};
};

/// Overlap tells of a body that leaves the masks, the rays of a limb that lies hidden in the trunk
/// while the masks show it elsewhere: their mean, 0 to 1.
double qualityOf(const ContourFit& fit);

/// Moves a body until the viewing rays of all contours touch it and no mask is left by it:
/// Levenberg-Marquardt with analytic derivatives, a robust error that narrows (Geman and McClure
/// 1987), soft joint limits, and weak priors of posture and motion. Immutable; one is shared by all
/// threads.
class ContourFitter {
 public:
  /// Throws std::invalid_argument if the options do.
  ContourFitter(const CameraRig& rig, const ContourOptions& options);
  const ContourOptions& options() const { return options_; }
  /// For a start that follows the last pose.
  RobustSchedule schedule() const;

  /// \param prediction empty when nothing is known from before
  /// Throws std::invalid_argument if the observation is of another rig, or start or prediction are
  /// not finite.
  ContourFit fit(const ContourObservation& seen, const ContourBody& body, const ContourPose& start,
                 const std::optional<ContourPrediction>& prediction,
                 const RobustSchedule& schedule) const;

 private:
  CameraRig rig_;
  ContourOptions options_;
};

}  // namespace markerless_mocap
