#include "hsiao/hsiao_tracker.h"

#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {

HsiaoTracker::HsiaoTracker(const PersonResources& resources, const PersonOptions& person,
                           const HsiaoOptions& options)
    : body_(initialBody(resources, person.stature)), tracker_(body_->model, options) {}

BodyPose HsiaoTracker::update(const TrackerInput& now) {
  const FrameProducts& made = now.products.ofThisFrame();
  return tracker_.update(now.stamp_ns, made.parts, made.hull);
}

}  // namespace markerless_mocap
