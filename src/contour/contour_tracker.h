#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contour/contour_urdf_converter.h"
#include "contour/measure/online_shape_estimator.h"
#include "contour/track/contour_multi_hypothesis_tracker.h"
#include "markerless_mocap/contour/contour_options.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/person_resources.h"
#include "tracking/pose_initializer.h"

namespace markerless_mocap {

/// Fits the body to the silhouettes' contours from instant to instant; where there is no last pose,
/// part curves and hull propose some.
class ContourMethod : public BodyTracker {
 public:
  /// Throws std::invalid_argument as makeBodyTracker().
  ContourMethod(const CameraRig& rig, PersonResources sources, const PersonOptions& person,
                const ContourOptions& options, InitializerFactory make_initializer);
  BodyPose update(const TrackerInput& now) override;
  void estimateShapeNow() override;
  void reset() override;
  const std::shared_ptr<const TrackedBody>& body() const override { return body_; }

 private:
  void takeOver(std::shared_ptr<const TrackedBody> body);
  /// Whether the estimate was ready.
  bool takeOverMeasured();
  void guessStature(const ContourObservation& seen, const std::vector<ContourPose>& poses);
  ActiveTrack start(const TrackerInput& now, const ContourObservation& seen);
  ActiveTrack reinitialize(const TrackerInput& now, const ContourObservation& seen,
                           const ActiveTrack& held);
  /// Whether what has been started may be claimed.
  bool isDecided(const ContourFit& fit) const;
  std::vector<ContourPose> proposals(const TrackerInput& now, const ContourObservation& seen);
  void reconsider(const TrackerInput& now, const ContourObservation& seen,
                  const ContourTrackingResult& track);
  /// While the body is being measured nothing is claimed.
  std::optional<BodyPose> measure(int64_t stamp_ns, const ContourObservation& seen,
                                  const ContourFit& fit);
  BodyPose lost(const ContourObservation& seen, const ContourTrackingResult& track) const;
  BodyPose undecided(const ContourFit& fit) const;
  BodyPose reported(const ActiveTrack& held);

  PersonResources sources_;
  PersonOptions person_;
  InitializerFactory make_initializer_;
  ContourObserver observer_;
  ContourHypotheses hypotheses_;
  bool decided_ = false;   ///< where the person is and faces, since the last start
  bool reported_ = false;  ///< a pose, since the last start
  int64_t sure_after_ns_ = 0, next_reconsideration_ns_ = 0, next_start_ns_ = 0;
  std::optional<OnlineShapeEstimator> measurer_;
  std::shared_ptr<const TrackedBody> body_;
  std::optional<ContourBody> shape_;                ///< of body_
  std::optional<ContourUrdfConverter> conversion_;  ///< to body_
  std::unique_ptr<PoseInitializer> initializer_;    ///< proposes starts
  std::optional<int64_t> stamp_;                    ///< of the last instant
  std::string initializer_error_;                   ///< why it proposes nothing
};

}  // namespace markerless_mocap
