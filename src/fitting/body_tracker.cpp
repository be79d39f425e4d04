#include "markerless_mocap/fitting/body_tracker.h"

#include <stdexcept>

#include "fitting/contour_method.h"
#include "fitting/skeleton_method.h"
#include "fitting/sppso_method.h"

namespace markerless_mocap {

std::unique_ptr<BodyTracker> makeBodyTracker(const CameraRig& rig, const TrackerSources& sources,
                                             const TrackerOptions& options) {
  options.validate();
  if (options.method == "skeleton") return std::make_unique<SkeletonMethod>(sources, options);
  if (rig.empty())
    throw std::invalid_argument("pose_fitting/method is " + options.method +
                                ", which needs cameras; without any, allowed is skeleton");
  if (options.method == "sppso") return std::make_unique<SppsoMethod>(rig, sources, options);
  return std::make_unique<ContourMethod>(rig, sources, options);
}

}  // namespace markerless_mocap
