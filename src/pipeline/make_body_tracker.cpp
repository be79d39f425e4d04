#include "markerless_mocap/pipeline/make_body_tracker.h"

#include <stdexcept>

#include "contour/contour_method.h"
#include "fleischmann/sppso_method.h"
#include "hsiao/skeleton_method.h"
#include "resources/resources.h"

namespace markerless_mocap {
namespace {

/// Proposes starts from part curves and hull.
InitializerFactory initializers(FittingOptions options) {
  return [options](std::shared_ptr<const BodyModel> model) {
    return std::make_unique<PoseTracker>(std::move(model), options);
  };
}

/// A start is one proposal among several that contours refine: one search for it does.
FittingOptions withOneAttempt(FittingOptions options) {
  options.start_attempts = 1;
  return options;
}

}  // namespace

std::unique_ptr<BodyTracker> makeBodyTracker(const CameraRig& rig, const PersonSources& sources,
                                             const TrackerOptions& options) {
  options.validate();
  const PersonOptions& person = options.person;
  if (options.method == "skeleton")
    return std::make_unique<SkeletonMethod>(sources, person, options.skeleton);
  if (rig.empty())
    throw std::invalid_argument("pose_fitting/method is " + options.method +
                                ", which needs cameras; without any, allowed is skeleton");
  if (options.method == "sppso")
    return std::make_unique<SppsoMethod>(rig, sources, person, options.sppso,
                                         MotionStatistics::fromYaml(motionStatisticsYaml()),
                                         initializers(options.skeleton));
  return std::make_unique<ContourMethod>(rig, sources, person, options.contour,
                                         initializers(withOneAttempt(options.skeleton)));
}

}  // namespace markerless_mocap
