// How ContourTracker measures the person.
#include "contour/contour_tracker.h"

#include <array>

#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {
namespace {

// Metres.
constexpr std::array<double, 5> kUsualStatures{1.5, 1.6, 1.7, 1.8, 1.9};
constexpr double kStatureStep = 0.15, kSmallest = 0.9, kLargest = 2.35;

}  // namespace

double ContourTracker::qualityAt(double stature, const ContourObservation& seen,
                                 const std::vector<ContourPose>& poses,
                                 const RobustSchedule& schedule) const {
  const ContourBody body(resources_.shape_statistics.meanShape(stature));
  return qualityOf(hypotheses_.bestFit(seen, body, poses, schedule));
}

// The shape estimate converges only from nearby, so it starts with the stature of best quality. A
// child, or a calibration whose metre is wrong, is beyond the usual ones.
void ContourTracker::initializeStature(const Frame& now, const std::vector<ContourPose>& poses,
                                       const RobustSchedule& schedule) {
  if (!shape_estimator_ || poses.empty()) return;
  const ContourObservation seen = now.regions.needsColors()
                                      ? observer_.observeRoughly(now.regions.masks)
                                      : observer_.observe(now.regions.masks);
  double best_stature = person_.stature, best_quality = 0.0;
  const auto isBetter = [&](double stature) {
    const double quality = qualityAt(stature, seen, poses, schedule);
    if (quality <= best_quality) return false;
    best_quality = quality;
    best_stature = stature;
    return true;
  };
  isBetter(person_.stature);
  for (const double stature : kUsualStatures) isBetter(stature);
  for (double stature = best_stature; stature >= kUsualStatures.back() && stature < kLargest;)
    if (!isBetter(stature += kStatureStep)) break;
  for (double stature = best_stature; stature <= kUsualStatures.front() && stature > kSmallest;)
    if (!isBetter(stature -= kStatureStep)) break;
  setBody(initialBody(resources_, best_stature));
  shape_estimator_->setStature(best_stature);
}

bool ContourTracker::measure(int64_t stamp_ns, const ContourObservation& seen,
                             const ContourFit& fit) {
  if (!shape_estimator_) return false;
  if (isBelieved() && hypotheses_.isUnambiguous())
    shape_estimator_->add(stamp_ns, seen, *contour_body_, fit);
  else
    shape_estimator_->skip(stamp_ns);
  return useEstimatedShape();
}

std::string ContourTracker::measuringProgress() const {
  return "the body is being measured, " + std::to_string(shape_estimator_->poses()) + " of " +
         std::to_string(person_.shape_poses) + " different poses have been seen";
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
  reported_ = false;  // the next pose is that of another body
  return true;
}

}  // namespace markerless_mocap
