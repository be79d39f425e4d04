#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "markerless_mocap/tracking/body_tracker.h"
#include "fleischmann/model/fleischmann_conversion.h"
#include "fleischmann/motion_statistics.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/person_sources.h"
#include "tracking/pose_initializer.h"
#include "fleischmann/sppso_tracker.h"

namespace markerless_mocap {

/// Searches the body by silhouettes and edges from instant to instant (Fleischmann 2012); where
/// there is no last pose, it starts near the one that part curves and hull propose.
class SppsoMethod : public BodyTracker {
 public:
  /// Throws std::invalid_argument as makeBodyTracker(), and if the motion statistics let nothing
  /// move.
  SppsoMethod(const CameraRig& rig, const PersonSources& sources, const PersonOptions& person,
              const SppsoOptions& options, const MotionStatistics& motion,
              const InitializerFactory& make_initializer);
  BodyPose update(const TrackingInstant& now) override;
  void reset() override;
  const std::shared_ptr<const TrackedBody>& body() const override { return body_; }

 private:
  std::vector<AppearanceView> viewsOf(const TrackingInstant& now) const;
  /// The pose that part curves and hull tell of this instant alone, searched on.
  SppsoPose proposed(const TrackingInstant& now, const std::vector<AppearanceView>& views,
                     double better_than);
  BodyPose start(const TrackingInstant& now, const std::vector<AppearanceView>& views);
  /// A swarm that has lost a limb rarely finds it again, but it looks less like the person.
  std::optional<SppsoPose> question(const TrackingInstant& now,
                                    const std::vector<AppearanceView>& views,
                                    const SppsoPose& found);
  BodyPose claimed(const SppsoPose& found, PoseStatus status);

  bool with_edges_;
  std::shared_ptr<const TrackedBody> body_;
  FleischmannConversion conversion_;
  SppsoTracker tracker_;
  std::unique_ptr<PoseInitializer> seeker_;  ///< proposes starts
  std::optional<int64_t> stamp_;  ///< of the last instant
  double usual_ = 0.0;            ///< silhouette fitness, near the best of this track
  int64_t next_question_ns_ = 0;
};

}  // namespace markerless_mocap
