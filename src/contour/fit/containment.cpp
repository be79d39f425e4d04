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

/// Signed distance to the border of the silhouette at a pixel, from the four samples around it.
class BorderDistance {
 public:
  BorderDistance(const ContourView& view, const Vector2d& pixel) : per_step_(1.0 / view.step) {
    const Vector2d at = pixel * per_step_ - Vector2d(view.corner.x, view.corner.y);
    const double right = view.distance.cols - 1, bottom = view.distance.rows - 1;
    const Vector2d inside(std::clamp(at.x(), 0.0, right), std::clamp(at.y(), 0.0, bottom));
    const int x = std::min(int(inside.x()), std::max(0, view.distance.cols - 2));
    const int y = std::min(int(inside.y()), std::max(0, view.distance.rows - 2));
    const float* top = view.distance.ptr<float>(y) + x;
    const float* low = view.distance.ptr<float>(std::min(y + 1, view.distance.rows - 1)) + x;
    const int next = view.distance.cols > 1 ? 1 : 0;
    u_ = inside.x() - x;
    v_ = inside.y() - y;
    across_top_ = top[next] - top[0];
    across_low_ = low[next] - low[0];
    above_ = top[0] + u_ * across_top_;
    below_ = low[0] + u_ * across_low_;
    beyond_ = (at - inside) * view.step;
    away_ = beyond_.isZero(0) ? 0.0 : beyond_.norm();
  }

  /// Pixels.
  double value() const { return above_ + v_ * (below_ - above_) + away_; }

  Vector2d gradient() const {
    Vector2d out((1 - v_) * across_top_ + v_ * across_low_, below_ - above_);
    out *= per_step_;
    for (int i = 0; i < 2; ++i)
      if (beyond_[i] != 0) out[i] = beyond_[i] / away_;
    return out;
  }

 private:
  double per_step_;
  double u_, v_;  ///< between the samples, 0 to 1
  double across_top_, across_low_, above_, below_;
  Vector2d beyond_;  ///< from the nearest place of the view, pixels
  double away_;      ///< its length
};

/// Distance of a sphere outside the mask of one view, metres, and its derivative with respect to
/// the centre.
struct SphereInView {
  double outside;
  Vector3d gradient;  ///< world
};

/// Empty if the sphere is inside the mask. \param middle in the camera's frame
std::optional<SphereInView> sphereInView(const Camera& camera, const ContourView& view,
                                         const Vector3d& middle, double radius) {
  const auto pixel = camera.projectFromCameraFrame(middle);
  if (!pixel || !camera.isInImage(*pixel)) return std::nullopt;
  const BorderDistance border(view, *pixel);
  const double distance = border.value();
  SphereInView sphere;
  sphere.outside = distance / camera.pixelsPerMetre(middle) + radius;
  if (!(sphere.outside > 0)) return std::nullopt;
  const Vector3d from_camera = camera.calibration().T_world_camera.linear() * middle;
  const LocalView lens = camera.localView(camera.position() + from_camera);
  const Vector3d p = lens.R_world_view.transpose() * from_camera;
  const double f = 0.5 * (lens.fx + lens.fy);
  const Vector2d slope = border.gradient().cwiseProduct(Vector2d(lens.fx, lens.fy)) / f;
  sphere.gradient = lens.R_world_view *
                    Vector3d(slope.x(), slope.y(), distance / f - slope.dot(p.head<2>()) / p.z());
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
    for (size_t c = 0; c < kContourCones; ++c) {
      if (!wanted(c)) continue;
      const ContourWorldCone& cone = cones[c];
      const Vector3d a = rig[v].inCameraFrame(cone.a), axis = rig[v].inCameraFrame(cone.b) - a;
      for (size_t i = 0; i < kSpheresPerCone; ++i) {
        const double s = double(i) / (kSpheresPerCone - 1);
        const double radius = cone.radius_a + s * (cone.radius_b - cone.radius_a);
        const auto sphere = sphereInView(rig[v], seen.views[v], a + s * axis, radius);
        if (sphere) add(c, i, s, *sphere);
      }
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
