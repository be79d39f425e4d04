#include "contour/track/contradicted_views.h"

#include <algorithm>

#include "contour/fit/body_overlap.h"

namespace markerless_mocap {
namespace {

// Quality and overlap of a view that shows the person are lower than those of most others by less,
// also behind a table. Those of a covered, blurred or turned camera are lower by 0.4 and more.
constexpr double kFar = 0.25;

void remove(size_t view, ContourObservation& seen) {
  seen.views[view] = ContourView();
  const auto is_of_view = [&](const ContourRay& ray) { return ray.camera == int(view); };
  seen.rays.erase(std::remove_if(seen.rays.begin(), seen.rays.end(), is_of_view), seen.rays.end());
}

}  // namespace

void ContradictedViews::note(const ContourFit& fit) {
  suspected_ = some_left_out_ || fit.worst_quality < fit.majority_quality - kFar;
}

void ContradictedViews::leaveOut(const CameraRig& rig, const ContourBody& body,
                                 const ContourPose& expected, ContourObservation& seen) {
  some_left_out_ = false;
  if (!suspected_ || seen.usableViews() == 0) return;
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(expected, frames);
  body.place(frames, cones);
  const std::vector<double> overlaps = viewOverlaps(seen, rig, cones);
  std::vector<double> usable;
  for (size_t v = 0; v < overlaps.size(); ++v)
    if (seen.views[v].status == ViewStatus::kUsable) usable.push_back(overlaps[v]);
  const double least = reachedByMost(usable) - kFar;
  for (size_t v = 0; v < overlaps.size(); ++v) {
    if (seen.views[v].status != ViewStatus::kUsable || overlaps[v] >= least) continue;
    remove(v, seen);
    some_left_out_ = true;
  }
}

}  // namespace markerless_mocap
