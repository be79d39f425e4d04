#pragma once

#include <array>
#include <optional>

#include "contour/fit/contour_observation.h"
#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// The pose expected from the previous motion.
struct ContourPrediction {
  ContourPose pose;
  double seconds = 0.0;  ///< since the frame it was predicted from, more than 0
};

/// Prediction with constant velocity. \param fraction of the last velocity that is kept, 0 to 1
ContourPose predictConstantVelocity(const ContourPose& before, const ContourPose& last,
                                    double fraction);

/// Number of steps, and the scale of the robust loss, which shrinks from step to step.
struct RobustSchedule {
  int iterations;
  double robust_scale_initial, robust_scale_final;  ///< metres

  /// For a start pose that may be wrong by tenths of a radian and decimetres.
  static RobustSchedule wide() { return {24, 0.3, 0.03}; }
};

/// Evidence for the position of a limb.
struct LimbEvidence {
  int rays = 0;               ///< rays that touch it, within kRayExplained
  double distance = 0.0;      ///< root mean square distance of these rays from its surface, metres
  double outside = 0.0;       ///< mean distance of its spheres outside the masks, metres
  double part_outside = 0.0;  ///< the same of that of its cones that is farthest outside, metres
  double inside = 0.0;        ///< of an arm or leg: fraction of its axis inside the trunk, 0 to 1
  /// Standard deviation of the position of its end (head, wrist, ankle; trunk: base of the neck),
  /// metres, given rays and posture priors. The variance of the rays of a limb follows from how
  /// well rays and masks agree with the limb. A ray of an arm counts less if the rest of the body
  /// explains it, too. Motion prior and containment do not count: they constrain a limb without
  /// showing where it is.
  double deviation = 0.0;
};

/// A ray is explained if it is nearer to the body than this, metres.
constexpr double kRayExplained = 0.03;

/// kTooFewViews: less than two usable masks. kDiverged: the pose is not finite.
enum class ContourFitStatus { kFitted, kTooFewViews, kDiverged };
const char* toString(ContourFitStatus status);

/// The other members are valid only if the status is kFitted.
struct ContourFit {
  ContourFitStatus status = ContourFitStatus::kTooFewViews;
  ContourPose pose;
  /// Mean overlap of body and masks over the usable views, 0 to 1: half the fraction of the body
  /// that is in the mask plus half the fraction of the mask that is in the body (Fleischmann 2012,
  /// 5.2.2).
  double overlap = 0.0;
  double rays_explained = 0.0;  ///< fraction of the rays nearer than kRayExplained, 0 to 1
  std::array<LimbEvidence, ContourLimb::kCount> limbs{};
  /// So well, see qualityOf(), do most usable views fit: more than half of them, and at least three
  /// if there are so many. A single wrong mask among four does not lower it.
  double majority_quality = 0.0;
  double worst_quality = 0.0;  ///< the same of the view that fits worst
};

/// Quality of a fit, 0 to 1: the mean of overlap and rays_explained. A low overlap indicates a body
/// outside the masks. Few explained rays indicate a limb that is hidden in the trunk while the
/// masks show it elsewhere.
double qualityOf(const ContourFit& fit);

/// Moves a body until the viewing rays of all contours touch it and it lies inside all masks:
/// damped Gauss-Newton steps with analytic derivatives, a robust loss whose scale shrinks (Geman
/// and McClure 1987), soft joint limits, and weak priors of posture and motion. Immutable; safe to
/// share between threads.
class ContourFitter {
 public:
  /// Throws std::invalid_argument if an option is out of range.
  ContourFitter(const CameraRig& rig, const ContourOptions& options);
  const ContourOptions& options() const { return options_; }
  /// For a start pose that was predicted over a time, in seconds.
  RobustSchedule schedule(double seconds) const;

  /// \param prediction empty without previous frames
  /// \param schedule number of steps and robust scales
  /// Throws std::invalid_argument if the observation is of another rig, or if start or prediction
  /// are not finite.
  ContourFit fit(const ContourObservation& seen, const ContourBody& body, const ContourPose& start,
                 const std::optional<ContourPrediction>& prediction,
                 const RobustSchedule& schedule) const;

 private:
  CameraRig rig_;
  ContourOptions options_;
};

}  // namespace markerless_mocap
