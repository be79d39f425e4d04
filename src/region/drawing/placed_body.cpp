#include "region/placed_body.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr float kMinSigma = 0.7f;  // samples
constexpr double kMinDepth = 0.1;  // m

double depthOf(const LocalView& lens, const Camera& camera, const Eigen::Vector3d& point) {
  return lens.R_world_view.col(2).dot(point - camera.position());
}

double focalLength(const LocalView& lens, int step) {
  return 0.5 * (lens.fx + lens.fy) / step;
}

}  // namespace

float samplesPerMetre(const Camera& camera, int step, const Eigen::Vector3d& point) {
  const LocalView lens = camera.localView(point);
  return float(focalLength(lens, step) / std::max(kMinDepth, depthOf(lens, camera, point)));
}

ProjectedBody projectedBody(const Camera& camera, int step, const PlacedBody& body,
                            double error_m) {
  const LocalView lens = camera.localView(body.pelvis);
  const double f = focalLength(lens, step);
  const Eigen::Vector2d centre = Eigen::Vector2d::Constant(0.5 * (step - 1));
  ProjectedBody out;
  for (const PlacedCone& cone : body.cones) {
    const auto a = camera.project(cone.a), b = camera.project(cone.b);
    if (!a || !b) continue;
    const double depth_a = depthOf(lens, camera, cone.a), depth_b = depthOf(lens, camera, cone.b);
    out.cones.push_back({((*a - centre) / step).cast<float>(), ((*b - centre) / step).cast<float>(),
                         float(f * cone.radius_a / depth_a), float(f * cone.radius_b / depth_b),
                         float(depth_a), float(depth_b), cone.part});
  }
  out.sigma = float(error_m) * samplesPerMetre(camera, step, body.pelvis) + kMinSigma;
  return out;
}

}  // namespace markerless_mocap
