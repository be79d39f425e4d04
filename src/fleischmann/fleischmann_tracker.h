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

/// Searches the pose by silhouettes and edges in each frame (Fleischmann 2012). Without a last
/// pose, the search starts near the one that an initializer proposes.
class FleischmannTracker : public BodyTracker {
 public:
  /// Throws std::invalid_argument if an option is out of range, if the rig has no cameras, if the
  /// URDF template describes no suitable body, or if all motion statistics are 0.
  FleischmannTracker(const CameraRig& rig, const PersonResources& resources,
                     const PersonOptions& person, const FleischmannOptions& options,
                     const FleischmannMotionStatistics& motion,
                     const InitializerFactory& make_initializer);
  BodyPose update(const TrackerInput& now) override;
  void reset() override;
  const std::shared_ptr<const TrackedBody>& body() const override { return body_; }

 private:
  std::vector<FleischmannView> viewsOf(const TrackerInput& now) const;
  /// The pose that the initializer proposes for this frame only, improved by a search.
  FleischmannEstimate proposed(const TrackerInput& now, const std::vector<FleischmannView>& views,
                               double better_than);
  BodyPose start(const TrackerInput& now, const std::vector<FleischmannView>& views);
  /// Tries the initializer's proposal if the fitness has decreased. A swarm that has lost a limb
  /// rarely finds it again, but its fitness is lower. Returns the proposal if it is clearly better.
  std::optional<FleischmannEstimate> reconsider(const TrackerInput& now,
                                                const std::vector<FleischmannView>& views,
                                                const FleischmannEstimate& found);
  BodyPose reported(const FleischmannEstimate& found, PoseStatus status);

  bool with_edges_, reconsiders_;
  std::shared_ptr<const TrackedBody> body_;
  FleischmannUrdfConverter conversion_;
  FleischmannPoseEstimator tracker_;
  std::unique_ptr<PoseInitializer> initializer_;  ///< proposes poses after a loss
  std::optional<int64_t> stamp_;                  ///< of the last frame
  double usual_ = 0.0;  ///< slowly decaying maximum of the silhouette fitness
  int64_t next_reconsideration_ns_ = 0;
};

}  // namespace markerless_mocap
