#include "contour/regions/region_observer.h"

namespace markerless_mocap {
namespace {

constexpr double kLearningError = 0.03;  // metres, of the outline of a fitted body

}  // namespace

RegionObserver::RegionObserver(const CameraRig& rig, const ContourOptions& options)
    : observer_(std::make_shared<ContourObserver>(rig, options)), regions_(rig) {}

RegionObservation RegionObserver::observe(const RegionFrame& frame) const {
  RegionObservation out;
  out.seen = observer_->observe(frame.masks);
  out.masks = frame.masks;
  out.limb_agreement.fill(1.0);
  return out;
}

RegionObservation RegionObserver::observeLargest(const RegionFrame& frame,
                                                 const VisualHull& hull) const {
  RegionObservation out;
  out.masks = regions_.largest(frame, hull);
  out.seen = frame.needsColors() ? observeRoughly(out.masks) : observe(out.masks);
  out.seen.masks_follow_pose = frame.needsColors();
  out.limb_agreement.fill(1.0);
  return out;
}

RegionObservation RegionObserver::observeNear(const RegionFrame& frame, const ContourBody& body,
                                              const ContourPose& pose, double error_m) const {
  const RegionMasks found = regions_.segment(frame, body, pose, error_m);
  RegionObservation out{
      frame.is_coarse ? observer_->observeRoughly(found.masks) : observer_->observe(found.masks),
      found.masks, found.agreement, found.overlap, found.limb_agreement};
  out.seen.masks_follow_pose = frame.needsColors();
  return out;
}

std::vector<cv::Mat> RegionObserver::candidates(const RegionFrame& frame, const VisualHull& hull,
                                                const ContourBody& body,
                                                const ContourPose& pose) const {
  return regions_.candidates(frame, hull, body, pose);
}

ContourObservation RegionObserver::observe(const std::vector<cv::Mat>& masks) const {
  return observer_->observe(masks);
}

ContourObservation RegionObserver::observeRoughly(const std::vector<cv::Mat>& masks) const {
  return observer_->observeRoughly(masks);
}

void RegionObserver::learn(const RegionFrame& frame, const ContourBody& body,
                           const ContourPose& pose) {
  regions_.learn(frame, body, pose, kLearningError);
}

}  // namespace markerless_mocap
