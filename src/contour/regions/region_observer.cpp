#include "contour/regions/region_observer.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr double kLearningError = 0.03;  // metres, of the outline of a fitted body

}  // namespace

RegionObserver::RegionObserver(const CameraRig& rig, const ContourOptions& options)
    : observer_(rig, options), regions_(rig) {}

RegionObservation RegionObserver::observe(const TrackerInput& now) const {
  RegionObservation out;
  out.seen = observer_.observe(now.masks);
  out.masks = now.masks;
  out.limb_agreement.fill(1.0);
  return out;
}

bool RegionObserver::needsColor(const TrackerInput& now) const {
  return std::any_of(now.images.begin(), now.images.end(),
                     [](const cv::Mat& image) { return !image.empty(); });
}

RegionObservation RegionObserver::observeNear(const TrackerInput& now, const ContourBody& body,
                                              const ContourPose& pose, double error_m) const {
  const RegionMasks found = regions_.segment(now.images, now.masks, body, pose, error_m);
  return {observer_.observe(found.masks), found.masks, found.agreement, found.overlap,
          found.limb_agreement};
}

std::vector<cv::Mat> RegionObserver::candidates(const TrackerInput& now, const ContourBody& body,
                                                const ContourPose& pose) const {
  return regions_.candidates(now.images, now.masks, body, pose);
}

ContourObservation RegionObserver::observe(const std::vector<cv::Mat>& masks) const {
  return observer_.observe(masks);
}

void RegionObserver::learn(const TrackerInput& now, const ContourBody& body,
                           const ContourPose& pose) {
  regions_.learn(now.images, body, pose, kLearningError);
}

}  // namespace markerless_mocap
