#pragma once

#include <memory>

#include "hsiao/hsiao_pose_estimator.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/person_resources.h"

namespace markerless_mocap {

/// Fits the body to the part curves and the hull (Hsiao 2008). The body has the mean proportions of
/// its stature.
class HsiaoTracker : public BodyTracker {
 public:
  HsiaoTracker(const PersonResources& resources, const PersonOptions& person,
               const HsiaoOptions& options);
  BodyPose update(const TrackerInput& now) override;
  void reset() override { tracker_.reset(); }
  const std::shared_ptr<const TrackedBody>& body() const override { return body_; }

 private:
  std::shared_ptr<const TrackedBody> body_;
  HsiaoPoseEstimator tracker_;
};

}  // namespace markerless_mocap
