#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fleischmann/fleischmann_motion_statistics.h"
#include "fleischmann/fleischmann_pose_estimator.h"
#include "fleischmann/model/fleischmann_urdf_converter.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/person_resources.h"
#include "tracking/pose_initializer.h"

namespace markerless_mocap {

/// Searches the body by silhouettes and edges from instant to instant (Fleischmann 2012); where
/// there is no last pose, it starts near the one that part curves and hull propose.
class FleischmannTracker : public BodyTracker {
 public:
  /// Throws std::invalid_argument as makeBodyTracker(), and if the motion statistics let nothing
  /// move.
  FleischmannTracker(const CameraRig& rig, const PersonResources& sources,
                     const PersonOptions& person, const FleischmannOptions& options,
                     const FleischmannMotionStatistics& motion,
                     const InitializerFactory& make_initializer);
  BodyPose update(const TrackerInput& now) override;
  void reset() override;
  const std::shared_ptr<const TrackedBody>& body() const override { return body_; }

 private:
  std::vector<FleischmannView> viewsOf(const TrackerInput& now) const;
  /// The pose that part curves and hull tell of this instant alone, searched on.
  FleischmannEstimate proposed(const TrackerInput& now, const std::vector<FleischmannView>& views,
                               double better_than);
  BodyPose start(const TrackerInput& now, const std::vector<FleischmannView>& views);
  /// A swarm that has lost a limb rarely finds it again, but it looks less like the person.
  std::optional<FleischmannEstimate> reconsider(const TrackerInput& now,
                                                const std::vector<FleischmannView>& views,
                                                const FleischmannEstimate& found);
  BodyPose reported(const FleischmannEstimate& found, PoseStatus status);

  bool with_edges_;
  std::shared_ptr<const TrackedBody> body_;
  FleischmannUrdfConverter conversion_;
  FleischmannPoseEstimator tracker_;
  std::unique_ptr<PoseInitializer> initializer_;  ///< proposes starts
  std::optional<int64_t> stamp_;                  ///< of the last instant
  double usual_ = 0.0;  ///< silhouette fitness, near the best of this track
  int64_t next_reconsideration_ns_ = 0;
};

}  // namespace markerless_mocap
