// How ContourTracker measures the person.
#include "contour/contour_tracker.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {

// The shape estimate converges only from nearby, so it starts with the stature of best quality.
void ContourTracker::initializeStature(const ContourObservation& seen,
                                       const std::vector<ContourPose>& poses) {
  double best_stature = person_.stature, best_quality = 0.0;
  for (const double stature : {1.5, 1.6, 1.7, 1.8, 1.9, person_.stature}) {
    const ContourBody body(resources_.shape_statistics.meanShape(stature));
    const double quality = qualityOf(hypotheses_.bestFit(seen, body, poses));
    if (quality <= best_quality) continue;
    best_quality = quality;
    best_stature = stature;
  }
  setBody(initialBody(resources_, best_stature));
  shape_estimator_->setStature(best_stature);
}

std::optional<BodyPose> ContourTracker::estimateShape(int64_t stamp_ns,
                                                      const ContourObservation& seen,
                                                      const ContourFit& fit) {
  if (!shape_estimator_) return std::nullopt;
  BodyPose pose;
  if (accepted_ && hypotheses_.isUnambiguous())
    shape_estimator_->add(stamp_ns, seen, *contour_body_, fit);
  if (useEstimatedShape()) {
    pose.reason = "the body has just been measured";  // the pose belongs to the old body
    return pose;
  }
  pose.reason = "the body is being measured, " + std::to_string(shape_estimator_->poses()) +
                " of " + std::to_string(person_.shape_poses) + " different poses have been seen";
  return pose;
}

void ContourTracker::estimateShapeNow() {
  if (!shape_estimator_) return;
  shape_estimator_->estimateNow();
  useEstimatedShape();
}

bool ContourTracker::useEstimatedShape() {
  const std::optional<ShapeParameters> shape = shape_estimator_->shape();
  if (!shape) return false;
  setBody(bodyFromShape(resources_, *shape));
  shape_estimator_.reset();
  return true;
}

}  // namespace markerless_mocap
