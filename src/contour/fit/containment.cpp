#include "contour/fit/containment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contour/fit/geman_mcclure.h"
#include "contour/fit/view_times.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Robust scale: a sphere further outside than this is an outlier, metres.
constexpr double kRobustScale = 0.15;

/// Signed distance to the border of the silhouette at a pixel, pixels, and its gradient.
struct BorderDistance {
  double value;
  Vector2d gradient;
};

BorderDistance sample(const ContourView& view, const Vector2d& pixel) {
  const Vector2d at = pixel / view.step - Vector2d(view.corner.x, view.corner.y);
  const double right = view.distance.cols - 1, bottom = view.distance.rows - 1;
  const Vector2d inside(std::clamp(at.x(), 0.0, right), std::clamp(at.y(), 0.0, bottom));
  const int x = std::min(int(inside.x()), std::max(0, view.distance.cols - 2));
  const int y = std::min(int(inside.y()), std::max(0, view.distance.rows - 2));
  const float* top = view.distance.ptr<float>(y) + x;
  const float* low = view.distance.ptr<float>(std::min(y + 1, view.distance.rows - 1)) + x;
  const int next = view.distance.cols > 1 ? 1 : 0;
  const double u = inside.x() - x, v = inside.y() - y;
  const double above = top[0] + u * (top[next] - top[0]), below = low[0] + u * (low[next] - low[0]);
  BorderDistance border;
  border.value = above + v * (below - above);
  border.gradient.x() = ((1 - v) * (top[next] - top[0]) + v * (low[next] - low[0])) / view.step;
  border.gradient.y() = (below - above) / view.step;
  const Vector2d beyond = (at - inside) * view.step;
  const double away = beyond.norm();
  if (away > 0) {
    border.value += away;
    for (int i = 0; i < 2; ++i)
      if (beyond[i] != 0) border.gradient[i] = beyond[i] / away;
  }
  return border;
}

/// Distance of a sphere outside the mask of one view, metres, and its derivative with respect to
/// the centre.
struct SphereInView {
  double outside;
  Vector3d gradient;  ///< world
};

/// Empty if the sphere is inside the mask.
std::optional<SphereInView> sphereInView(const Camera& camera, const ContourView& view,
                                         const Vector3d& middle, double radius) {
  const auto pixel = camera.projectInside(middle);
  if (!pixel) return std::nullopt;
  const BorderDistance border = sample(view, *pixel);
  const LocalView lens = camera.localView(middle);
  const Vector3d p = lens.R_world_view.transpose() * (middle - camera.position());
  const double fx = lens.fx, fy = lens.fy, f = 0.5 * (fx + fy);
  SphereInView sphere;
  sphere.outside = border.value * p.z() / f + radius;
  if (!(sphere.outside > 0)) return std::nullopt;
  const double gx = border.gradient.x() * fx / f, gy = border.gradient.y() * fy / f;
  const Vector3d gradient(gx, gy, border.value / f - (gx * p.x() + gy * p.y()) / p.z());
  sphere.gradient = lens.R_world_view * gradient;
  return sphere;
}

/// Calls add(cone, sphere, s, result) for every sphere that lies outside a usable mask of the views
/// from `first` to before `end`, for the cones with wanted(cone).
template <typename Wanted, typename Add>
void forEachViolation(const ContourObservation& seen, const CameraRig& rig, size_t first,
                      size_t end, const ContourWorldCones& body, const Wanted& wanted,
                      const Add& add) {
  for (size_t v = first; v < end; ++v) {
    if (seen.views[v].status != ViewStatus::kUsable) continue;
    const ContourWorldCones cones = conesIn(seen.views[v], body);
    for (size_t c = 0; c < kContourCones; ++c)
      for (size_t i = 0; wanted(c) && i < kSpheresPerCone; ++i) {
        const double s = double(i) / (kSpheresPerCone - 1);
        const ContourWorldCone& cone = cones[c];
        const double radius = cone.radius_a + s * (cone.radius_b - cone.radius_a);
        const auto sphere =
            sphereInView(rig[v], seen.views[v], cone.a + s * (cone.b - cone.a), radius);
        if (sphere) add(c, i, s, *sphere);
      }
  }
}

}  // namespace

SphereViolation addContainment(const ContourObservation& seen, const CameraRig& rig,
                               const ContourWorldCones& cones, double weight, size_t first,
                               size_t end, AllConeNormalEquations& sums) {
  SphereViolation max_outside{};
  const auto all = [](size_t) { return true; };
  forEachViolation(
      seen, rig, first, end, cones, all,
      [&](size_t c, size_t i, double s, const SphereInView& sphere) {
        max_outside[c][i] = std::max(max_outside[c][i], sphere.outside);
        const double u[4] = {sphere.gradient.x(), sphere.gradient.y(), sphere.gradient.z(), 1.0};
        sums[c].add(s, u, sphere.outside,
                    weight * gemanMcClureWeight(sphere.outside, kRobustScale));
      });
  return max_outside;
}

double containmentEnergy(const ContourObservation& seen, const CameraRig& rig,
                         const ContourWorldCones& cones, ContourLimb::Id limb) {
  double sum = 0.0;
  const auto of_limb = [&](size_t cone) { return limbOfCone(int(cone)) == limb; };
  forEachViolation(seen, rig, 0, rig.size(), cones, of_limb,
                   [&](size_t, size_t, double, const SphereInView& sphere) {
                     sum += gemanMcClureLoss(sphere.outside, kRobustScale);
                   });
  return sum;
}

}  // namespace markerless_mocap
