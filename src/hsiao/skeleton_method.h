#pragma once

#include <memory>

#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/person_sources.h"
#include "hsiao/pose_tracker.h"

namespace markerless_mocap {

/// Fits the part curves and the hull (Hsiao 2008); the body has the proportions of its stature.
class SkeletonMethod : public BodyTracker {
 public:
  SkeletonMethod(const PersonSources& sources, const PersonOptions& person,
                 const FittingOptions& options);
  BodyPose update(const TrackingInstant& now) override;
  void reset() override { tracker_.reset(); }
  const std::shared_ptr<const TrackedBody>& body() const override { return body_; }

 private:
  std::shared_ptr<const TrackedBody> body_;
  PoseTracker tracker_;
};

}  // namespace markerless_mocap
