#include "fitting/skeleton_method.h"

#include "fitting/tracked_person.h"

namespace markerless_mocap {

SkeletonMethod::SkeletonMethod(const TrackerSources& sources, const TrackerOptions& options)
    : body_(bodyBeforehand(sources, options.skeleton.stature)),
      tracker_(body_->model, options.skeleton) {}

BodyPose SkeletonMethod::update(const TrackingInstant& now) {
  return tracker_.update(now.stamp_ns, now.parts, now.hull);
}

}  // namespace markerless_mocap
