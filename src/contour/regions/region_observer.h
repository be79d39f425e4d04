#pragma once

#include <memory>

#include "contour/fit/contour_observation.h"
#include "contour/regions/body_regions.h"

namespace markerless_mocap {

/// What colours show around a pose.
struct RegionObservation {
  ContourObservation seen;
  std::vector<cv::Mat> masks;  ///< by camera, what `seen` was made of
  double agreement = 1.0;      ///< see RegionMasks
  double overlap = 1.0;        ///< see RegionMasks
  std::array<double, ContourLimb::kCount> limb_agreement;
};

/// Converts masks to the data that a body is fitted to. Where background subtraction left samples
/// unknown, colours around a pose decide. Not thread-safe.
class RegionObserver {
 public:
  /// Throws std::invalid_argument as ContourObserver.
  RegionObserver(const CameraRig& rig, const ContourOptions& options);
  const CameraRig& rig() const { return observer_->rig(); }

  /// What the masks show; unknown samples are no evidence.
  RegionObservation observe(const RegionFrame& frame) const;
  /// What the largest silhouettes show that the person can have, see BodyRegions::largest(). If
  /// colours are needed, fewer rays are enough: it selects proposals.
  RegionObservation observeLargest(const RegionFrame& frame, const VisualHull& hull) const;
  /// As observe(), but colours around `pose` decide in views with an unknown background. A coarse
  /// frame gives fewer rays.
  /// \param error_m expected error of the outline of the body in `pose`, metres
  RegionObservation observeNear(const RegionFrame& frame, const ContourBody& body,
                                const ContourPose& pose, double error_m) const;
  /// Where the person is or may be, see BodyRegions::candidates().
  std::vector<cv::Mat> candidates(const RegionFrame& frame, const VisualHull& hull,
                                  const ContourBody& body, const ContourPose& pose) const;
  ContourObservation observe(const std::vector<cv::Mat>& masks) const;
  /// With fewer rays.
  ContourObservation observeRoughly(const std::vector<cv::Mat>& masks) const;
  /// Throws std::invalid_argument if the masks do not fit the rig.
  void check(const std::vector<cv::Mat>& masks) const { observer_->check(masks); }
  /// As ContourObserver; thread-safe.
  void prepare(size_t camera, const cv::Mat& mask) const { observer_->prepare(camera, mask); }
  /// Learns the colours of the person and the surroundings. \param pose one that is believed
  void learn(const RegionFrame& frame, const ContourBody& body, const ContourPose& pose);
  /// Forgets the colours.
  void reset() { regions_.reset(); }
  /// The same, but it has not learned any colours.
  RegionObserver withoutColors() const { return {observer_, BodyRegions(regions_.rig())}; }

 private:
  RegionObserver(std::shared_ptr<const ContourObserver> observer, BodyRegions regions)
      : observer_(std::move(observer)), regions_(std::move(regions)) {}

  std::shared_ptr<const ContourObserver> observer_;  ///< large, so it is shared
  BodyRegions regions_;
};

}  // namespace markerless_mocap
