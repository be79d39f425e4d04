#include "contour/track/contradicted_views.h"

#include <algorithm>

#include "contour/fit/body_overlap.h"
#include "contour/fit/view_times.h"

namespace markerless_mocap {
namespace {

// Quality and overlap of a view that shows the person are lower than those of most others by less,
// also behind a table. Those of a covered, blurred or turned camera are lower by 0.35 and more.
constexpr double kFar = 0.25;

}  // namespace

std::string ContradictedViews::described(const CameraRig& rig) const {
  std::string names;
  for (const size_t camera : cameras_) names += (names.empty() ? "" : ", ") + rig[camera].name();
  return names.empty() ? "" : "left out, as most other cameras contradict their masks: " + names;
}

void ContradictedViews::leaveOut(ContourObservation& seen) const {
  for (const size_t camera : cameras_) {
    if (seen.views[camera].status != ViewStatus::kUsable) continue;
    seen.views[camera].status = ViewStatus::kContradicted;
    const auto is_its = [&](const ContourRay& ray) { return ray.camera == int(camera); };
    seen.rays.erase(std::remove_if(seen.rays.begin(), seen.rays.end(), is_its), seen.rays.end());
  }
}

bool ContradictedViews::leaveAnyOf(std::vector<bool> views) const {
  for (const size_t camera : cameras_)
    if (camera < views.size()) views[camera] = false;
  return std::find(views.begin(), views.end(), true) != views.end();
}

bool ContradictedViews::judge(const CameraRig& rig, const ContourBody& body,
                              const ContourObservation& seen, const ContourFit& fit) {
  if (cameras_.empty() && fit.worst_quality >= fit.majority_quality - kFar) return false;
  cameras_.clear();
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(fit.pose, frames);
  body.place(frames, cones);
  std::vector<size_t> cameras;
  std::vector<double> overlaps;
  for (size_t c = 0; c < rig.size(); ++c) {
    const ContourView& view = seen.views[c];
    if (view.status != ViewStatus::kUsable && view.status != ViewStatus::kContradicted) continue;
    cameras.push_back(c);
    overlaps.push_back(viewOverlap(view, rig[c], conesIn(view, cones)));
  }
  const double least = reachedByMost(overlaps) - kFar;
  bool found_more = false;
  for (size_t i = 0; i < cameras.size(); ++i) {
    if (overlaps[i] >= least) continue;
    cameras_.push_back(cameras[i]);
    found_more |= seen.views[cameras[i]].status == ViewStatus::kUsable;
  }
  return found_more;
}

}  // namespace markerless_mocap
