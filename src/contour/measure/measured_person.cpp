#include "contour/measure/measured_person.h"

#include <utility>

namespace markerless_mocap {

MeasuredPerson::MeasuredPerson(const CameraRig& rig, PersonResources resources,
                               const PersonOptions& person, const ContourOptions& options)
    : resources_(std::move(resources)), options_(person), stature_(person.stature) {
  setBody(initialBody(resources_, stature_));
  if (!options_.measure || tracked_->shape_estimated) return;
  const ShapePrior prior{resources_.shape_statistics, options_.stature, options_.stature_sigma};
  estimator_.emplace(rig, options, prior, options_.shape_poses, resources_.in_background);
}

void MeasuredPerson::setBody(std::shared_ptr<const TrackedBody> body) {
  tracked_ = std::move(body);
  body_.emplace(tracked_->shape);
  converter_.emplace(tracked_->model);
}

ContourBody MeasuredPerson::meanBody(double stature) const {
  return ContourBody(resources_.shape_statistics.meanShape(stature));
}

std::string MeasuredPerson::progress() const {
  if (!estimator_) return "";
  return "the body is being measured, " + std::to_string(estimator_->poses()) + " of " +
         std::to_string(options_.shape_poses) + " different poses have been seen";
}

void MeasuredPerson::setStature(double stature) {
  if (!estimator_) return;
  stature_ = stature;
  setBody(initialBody(resources_, stature));
  estimator_->setStature(stature);
}

void MeasuredPerson::add(int64_t stamp_ns, const ContourObservation& seen, const ContourFit& fit,
                         bool usable) {
  if (!estimator_) return;
  if (usable)
    estimator_->add(stamp_ns, seen, *body_, fit);
  else
    estimator_->skip(stamp_ns);
}

void MeasuredPerson::measureNow() {
  if (estimator_) estimator_->estimateNow();
}

bool MeasuredPerson::takeMeasured() {
  if (!estimator_) return false;
  const std::optional<ShapeParameters> shape = estimator_->shape();
  if (!shape) return false;
  setBody(bodyFromShape(resources_, *shape));
  estimator_.reset();
  return true;
}

}  // namespace markerless_mocap
