#include "contour/fit/ray_match.h"

#include <algorithm>

#include "contour/fit/view_times.h"
#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

constexpr int kLanes = PackedContourCones::kLanes;

constexpr float kTurnPenalty = 0.06f;  // metres per 1 - cos
constexpr float kWrongSide = 0.3f;     // cosine below which a cone is on the wrong side
constexpr float kNothing = 1e-12f;     // square metres: avoids division by zero

/// Distances between rays and cones. Seen along the ray, a cone is the convex hull of two circles
/// and its axis a line. s is the point of the axis whose circle is nearest to the ray. It is
/// shifted from the foot of the perpendicular by the taper.
struct Lanes {
  float s[kLanes], residual[kLanes], normal[kLanes], side[kLanes], score[kLanes];
};

struct PlainRay {
  float normal[3], side[3], normal_of_ray, side_of_ray;
};

// A cloned function inlines only builtins. The loop therefore calls no functions and reads plain
// numbers. cmake/core.cmake disables errno for its square roots.
MOCAP_WIDEST void measure(const PackedContourCones& cones, const PlainRay& ray, Lanes& out) {
  const float nx = ray.normal[0], ny = ray.normal[1], nz = ray.normal[2], n0 = ray.normal_of_ray;
  const float sx = ray.side[0], sy = ray.side[1], sz = ray.side[2], s0 = ray.side_of_ray;
  for (int i = 0; i < kLanes; ++i) {
    const float an = nx * cones.ax[i] + ny * cones.ay[i] + nz * cones.az[i] - n0;
    const float as = sx * cones.ax[i] + sy * cones.ay[i] + sz * cones.az[i] - s0;
    const float un = nx * cones.bx[i] + ny * cones.by[i] + nz * cones.bz[i] - n0 - an;
    const float us = sx * cones.bx[i] + sy * cones.by[i] + sz * cones.bz[i] - s0 - as;
    const float length2 = un * un + us * us + kNothing, taper = cones.rb[i] - cones.ra[i];
    const float across = __builtin_fabsf(an * us - as * un);
    const float rest = length2 - taper * taper;
    const float safe = rest > kNothing ? rest : kNothing;
    const float foot = (across * taper / __builtin_sqrtf(safe) - (an * un + as * us)) / length2;
    const float low = foot > 0.0f ? foot : 0.0f, s = low < 1.0f ? low : 1.0f;
    const float cn = an + s * un, cs = as + s * us;
    const float distance = __builtin_sqrtf(cn * cn + cs * cs + kNothing),
                radius = cones.ra[i] + s * taper;
    const float cosine = -cn / distance;
    const bool right_side = cosine >= kWrongSide;
    const float residual = (right_side ? distance : -cn) - radius;
    out.s[i] = s;
    out.residual[i] = residual;
    out.normal[i] = right_side ? cn / distance : -1.0f;
    out.side[i] = right_side ? cs / distance : 0.0f;
    out.score[i] = __builtin_fabsf(residual) + kTurnPenalty * (1.0f - cosine);
  }
}

}  // namespace

PackedContourCones::PackedContourCones(const ContourWorldCones& cones) {
  constexpr float kFar = 1e4f;  // metres
  for (int i = 0; i < kLanes; ++i) {
    const bool real = i < kContourCones;
    const ContourWorldCone& cone = cones[size_t(real ? i : 0)];
    const Eigen::Vector3f a =
        real ? Eigen::Vector3f(cone.a.cast<float>()) : Eigen::Vector3f::Constant(kFar);
    const Eigen::Vector3f b = real ? Eigen::Vector3f(cone.b.cast<float>()) : a;
    ax[i] = a.x(), ay[i] = a.y(), az[i] = a.z(), ra[i] = float(cone.radius_a);
    bx[i] = b.x(), by[i] = b.y(), bz[i] = b.z(), rb[i] = float(cone.radius_b);
  }
}

ConesInViews::ConesInViews(const ContourObservation& seen, const ContourWorldCones& cones) {
  const bool in_step = std::none_of(seen.views.begin(), seen.views.end(),
                                    [](const ContourView& view) { return bool(view.shifts); });
  if (in_step) packed_.emplace_back(cones);
  for (size_t i = 0; !in_step && i < seen.views.size(); ++i)
    packed_.emplace_back(conesIn(seen.views[i], cones));
}

void matchRays(const ConesInViews& cones, const std::vector<ContourRay>& rays,
               std::vector<RayMatch>& matches) {
  matches.resize(rays.size());
  matchRays(cones, rays, 0, rays.size(), matches);
}

void matchRays(const ConesInViews& cones, const std::vector<ContourRay>& rays, size_t first,
               size_t end, std::vector<RayMatch>& matches) {
  Lanes lanes;
  for (size_t r = first; r < end; ++r) {
    const ContourRay& ray = rays[r];
    measure(cones[ray.camera],
            {{ray.normal.x(), ray.normal.y(), ray.normal.z()},
             {ray.side.x(), ray.side.y(), ray.side.z()},
             ray.normal_of_ray,
             ray.side_of_ray},
            lanes);
    int best = 0;
    for (int i = 1; i < kContourCones; ++i)
      if (lanes.score[i] < lanes.score[best]) best = i;
    matches[r] = {best, lanes.s[best], lanes.residual[best], lanes.normal[best], lanes.side[best]};
  }
}

}  // namespace markerless_mocap
