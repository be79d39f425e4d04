#include "contour/regions/projected_body.h"

#include <algorithm>

#include "contour/model/contour_kinematics.h"

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

float samplesPerMetre(const Camera& camera, int step, const ContourPose& pose) {
  const LocalView lens = camera.localView(pose.position);
  const double depth = std::max(kMinDepth, depthOf(lens, camera, pose.position));
  return float(focalLength(lens, step) / depth);
}

ProjectedBody projectedBody(const Camera& camera, int step, const ContourBody& body,
                            const ContourPose& pose, double error_m) {
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(pose, frames);
  body.place(frames, cones);
  const LocalView lens = camera.localView(pose.position);
  const double f = focalLength(lens, step);
  const Eigen::Vector2d centre = Eigen::Vector2d::Constant(0.5 * (step - 1));
  ProjectedBody out;
  for (size_t c = 0; c < cones.size(); ++c) {
    const auto a = camera.project(cones[c].a), b = camera.project(cones[c].b);
    if (!a || !b) continue;
    const double depth_a = depthOf(lens, camera, cones[c].a),
                 depth_b = depthOf(lens, camera, cones[c].b);
    out.cones.push_back({((*a - centre) / step).cast<float>(), ((*b - centre) / step).cast<float>(),
                         float(f * cones[c].radius_a / depth_a),
                         float(f * cones[c].radius_b / depth_b), float(depth_a), float(depth_b),
                         int(contourKinematicTree().cones[c].ends[0].segment)});
  }
  out.sigma = float(error_m) * samplesPerMetre(camera, step, pose) + kMinSigma;
  return out;
}

}  // namespace markerless_mocap
