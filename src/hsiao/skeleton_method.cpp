#include "hsiao/skeleton_method.h"

#include "tracking/tracked_person.h"

namespace markerless_mocap {

SkeletonMethod::SkeletonMethod(const PersonSources& sources, const PersonOptions& person,
                               const FittingOptions& options)
    : body_(bodyBeforehand(sources, person.stature)),
      tracker_(body_->model, options) {}

BodyPose SkeletonMethod::update(const TrackingInstant& now) {
  return tracker_.update(now.stamp_ns, now.parts, now.hull);
}

}  // namespace markerless_mocap
