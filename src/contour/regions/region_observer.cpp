#include "contour/regions/region_observer.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr double kLearningError = 0.03;  // metres, of the outline of a fitted body

}  // namespace

RegionObserver::RegionObserver(const CameraRig& rig, const ContourOptions& options)
    : observer_(rig, options), regions_(rig) {}

ContourObservation RegionObserver::observe(const TrackerInput& now) const {
  return observer_.observe(now.masks);
}

bool RegionObserver::needsColor(const TrackerInput& now) const {
  for (size_t i = 0; i < now.masks.size(); ++i)
    if (needsRegions(now.images[i], now.masks[i])) return true;
  return false;
}

RegionObservation RegionObserver::observeNear(const TrackerInput& now, const ContourBody& body,
                                              const ContourPose& pose, double error_m) const {
  const RegionMasks found = regions_.segment(now.images, now.masks, body, pose, error_m);
  return {observer_.observe(found.masks), found.agreement};
}

void RegionObserver::learn(const TrackerInput& now, const ContourBody& body,
                           const ContourPose& pose) {
  regions_.learn(now.images, now.masks, body, pose, kLearningError);
}

}  // namespace markerless_mocap
