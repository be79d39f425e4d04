#include "markerless_mocap/tracking/tracked_body.h"

#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {
namespace {

std::shared_ptr<const TrackedBody> bodyOf(const PersonResources& resources,
                                          const BodyProportions& proportions,
                                          const ShapeParameters& shape, bool measured) {
  auto body = std::make_shared<TrackedBody>();
  body->urdf = fillUrdfTemplate(resources.urdf_template, resources.body_id, proportions);
  body->model =
      std::make_shared<const BodyModel>(BodyModel::fromUrdf(body->urdf, resources.body_id));
  body->shape = shape;
  body->shape_estimated = measured;
  return body;
}

}  // namespace

std::shared_ptr<const TrackedBody> initialBody(const PersonResources& resources, double stature) {
  if (resources.known_shape) return bodyFromShape(resources, *resources.known_shape);
  return bodyOf(resources, BodyProportions::fromStature(stature),
                resources.shape_statistics.meanShape(stature), false);
}

std::shared_ptr<const TrackedBody> bodyFromShape(const PersonResources& resources,
                                                 const ShapeParameters& shape) {
  return bodyOf(resources, proportionsOf(shape), shape, true);
}

}  // namespace markerless_mocap
