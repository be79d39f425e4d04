#include "markerless_mocap/pipeline/make_body_tracker.h"

#include <stdexcept>

#include "contour/contour_tracker.h"
#include "fleischmann/fleischmann_tracker.h"
#include "hsiao/hsiao_tracker.h"
#include "resources/resources.h"

namespace markerless_mocap {
namespace {

/// Makes initializers that propose poses from part curves and hull.
InitializerFactory initializers(const HsiaoOptions& options) {
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

using Maker = std::unique_ptr<BodyTracker> (*)(const CameraRig&, const PersonResources&,
                                               const TrackerOptions&);

std::unique_ptr<BodyTracker> makeContour(const CameraRig& rig, const PersonResources& resources,
                                         const TrackerOptions& options) {
  return std::make_unique<ContourTracker>(rig, resources, options.person, options.contour,
                                          initializers(withOneAttempt(options.hsiao)));
}

std::unique_ptr<BodyTracker> makeHsiao(const CameraRig&, const PersonResources& resources,
                                       const TrackerOptions& options) {
  return std::make_unique<HsiaoTracker>(resources, options.person, options.hsiao);
}

std::unique_ptr<BodyTracker> makeFleischmann(const CameraRig& rig, const PersonResources& resources,
                                             const TrackerOptions& options) {
  return std::make_unique<FleischmannTracker>(
      rig, resources, options.person, options.fleischmann,
      FleischmannMotionStatistics::fromYaml(motionStatisticsYaml()), initializers(options.hsiao));
}

struct Method {
  const char* name;
  TrackerNeeds needs;
  Maker make;
};

constexpr Method kMethods[] = {{"contour", {true, false, true, true}, &makeContour},
                               {"hsiao", {false, false, false, false}, &makeHsiao},
                               {"fleischmann", {true, true, false, false}, &makeFleischmann}};

const Method& methodNamed(const std::string& name) {
  for (const Method& method : kMethods)
    if (name == method.name) return method;
  throw std::invalid_argument("there is no method " + name);
}

}  // namespace

TrackerNeeds needsOf(const std::string& method) {
  return methodNamed(method).needs;
}

std::unique_ptr<BodyTracker> makeBodyTracker(const CameraRig& rig, const PersonResources& resources,
                                             const TrackerOptions& options) {
  options.validate();
  const Method& method = methodNamed(options.method);
  if (method.needs.masks && rig.empty())
    throw std::invalid_argument(
        "pose_fitting/method is " + options.method +
        ", which needs a rig with cameras; without cameras, allowed is hsiao");
  return method.make(rig, resources, options);
}

}  // namespace markerless_mocap
