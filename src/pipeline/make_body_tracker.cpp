#include "markerless_mocap/pipeline/make_body_tracker.h"

#include <stdexcept>

#include "contour/contour_tracker.h"
#include "fleischmann/fleischmann_tracker.h"
#include "hsiao/hsiao_tracker.h"
#include "resources/resources.h"

namespace markerless_mocap {
namespace {

/// Makes initializers that propose poses from part curves and hull.
InitializerFactory initializers(HsiaoOptions options) {
  return [options](std::shared_ptr<const BodyModel> model) {
    return std::make_unique<HsiaoPoseEstimator>(std::move(model), options);
  };
}

/// The contour tracker refines several proposals, and this is only one of them: one attempt is
/// enough.
HsiaoOptions withOneAttempt(HsiaoOptions options) {
  options.initialization_attempts = 1;
  return options;
}

}  // namespace

std::unique_ptr<BodyTracker> makeBodyTracker(const CameraRig& rig, const PersonResources& resources,
                                             const TrackerOptions& options) {
  options.validate();
  const PersonOptions& person = options.person;
  if (options.method == "hsiao")
    return std::make_unique<HsiaoTracker>(resources, person, options.hsiao);
  if (rig.empty())
    throw std::invalid_argument(
        "pose_fitting/method is " + options.method +
        ", which needs a rig with cameras; without cameras, allowed is hsiao");
  if (options.method == "fleischmann")
    return std::make_unique<FleischmannTracker>(
        rig, resources, person, options.fleischmann,
        FleischmannMotionStatistics::fromYaml(motionStatisticsYaml()), initializers(options.hsiao));
  return std::make_unique<ContourTracker>(rig, resources, person, options.contour,
                                          initializers(withOneAttempt(options.hsiao)));
}

}  // namespace markerless_mocap
