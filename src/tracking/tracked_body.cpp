#include "markerless_mocap/tracking/tracked_body.h"

#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {
namespace {

std::shared_ptr<const TrackedBody> bodyOf(const PersonResources& sources,
                                          const BodyProportions& proportions,
                                          const ShapeParameters& sizes, bool measured) {
  auto body = std::make_shared<TrackedBody>();
  body->urdf = fillUrdfTemplate(sources.urdf_template, sources.body_id, proportions);
  body->model = std::make_shared<const BodyModel>(BodyModel::fromUrdf(body->urdf, sources.body_id));
  body->sizes = sizes;
  body->measured = measured;
  return body;
}

}  // namespace

std::shared_ptr<const TrackedBody> initialBody(const PersonResources& sources, double stature) {
  if (sources.measured) return bodyFromShape(sources, *sources.measured);
  return bodyOf(sources, BodyProportions::fromStature(stature), sources.people.sizes(stature),
                false);
}

std::shared_ptr<const TrackedBody> bodyFromShape(const PersonResources& sources,
                                                 const ShapeParameters& sizes) {
  return bodyOf(sources, proportionsOf(sizes), sizes, true);
}

}  // namespace markerless_mocap
