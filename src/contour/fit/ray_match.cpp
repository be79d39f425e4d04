#include "contour/fit/ray_match.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contour/fit/view_times.h"
#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

constexpr int kLanes = PackedContourCones::kLanes;

constexpr float kTurnPenalty = 0.06f;  // metres per 1 - cos
constexpr float kWrongSide = 0.3f;     // cosine below which a cone is on the wrong side
constexpr float kNothing = 1e-12f;     // square metres: avoids division by zero

/// Distances between a ray and all cones. Seen along the ray, a cone is the convex hull of two
/// circles and its axis a line. s is the point of the axis whose circle is nearest to the ray. It
/// is shifted from the foot of the perpendicular by the taper.
struct Lanes {
  float s[kLanes], residual[kLanes];
  float normal[kLanes], side[kLanes];  ///< from the ray to the point of the axis, metres
};

struct PlainRay {
  float normal[3], side[3], normal_of_ray, side_of_ray;
};

// The index of a cone in the last bits of its score: the least score brings it along.
constexpr int kIndexBits = 31;
static_assert(kLanes <= kIndexBits + 1, "an index fits into the bits");

/// Returns the index of the cone with the least score, and of equal ones the first. That of
/// distances without meaning (a pose that diverges) is a cone, too.
// A cloned function inlines only builtins. The loop therefore calls no functions and reads plain
// numbers. cmake/core.cmake disables errno for its square roots.
MOCAP_VECTORISED int measure(const PackedContourCones& cones, const PlainRay& ray, Lanes& out) {
  const float nx = ray.normal[0], ny = ray.normal[1], nz = ray.normal[2], n0 = ray.normal_of_ray;
  const float sx = ray.side[0], sy = ray.side[1], sz = ray.side[2], s0 = ray.side_of_ray;
  int least = std::numeric_limits<int>::max();
  for (int i = 0; i < kLanes; ++i) {
    const float an = nx * cones.ax[i] + ny * cones.ay[i] + nz * cones.az[i] - n0;
    const float as = sx * cones.ax[i] + sy * cones.ay[i] + sz * cones.az[i] - s0;
    const float un = nx * cones.ux[i] + ny * cones.uy[i] + nz * cones.uz[i];
    const float us = sx * cones.ux[i] + sy * cones.uy[i] + sz * cones.uz[i];
    const float length2 = un * un + us * us + kNothing, taper = cones.taper[i];
    const float across = __builtin_fabsf(an * us - as * un);
    const float rest = length2 - taper * taper;
    const float root = __builtin_sqrtf(rest > kNothing ? rest : kNothing);
    const float foot = (across * taper - (an * un + as * us) * root) / (length2 * root);
    const float low = foot > 0.0f ? foot : 0.0f, s = low < 1.0f ? low : 1.0f;
    const float cn = an + s * un, cs = as + s * us;
    const float distance = __builtin_sqrtf(cn * cn + cs * cs + kNothing);
    const float cosine = -cn / distance;
    const float residual = (cosine >= kWrongSide ? distance : -cn) - (cones.radius[i] + s * taper);
    out.s[i] = s;
    out.residual[i] = residual;
    out.normal[i] = cn;
    out.side[i] = cs;
    const float score = __builtin_fabsf(residual) + kTurnPenalty * (1.0f - cosine);
    int bits;  // of numbers that are not negative, in their order
    __builtin_memcpy(&bits, &score, sizeof bits);
    bits = (bits & ~kIndexBits) | i;
    least = bits < least ? bits : least;
  }
  return least & kIndexBits;
}

RayMatch matchTo(int cone, const Lanes& lanes) {
  const float normal = lanes.normal[cone], side = lanes.side[cone];
  const float distance = std::sqrt(normal * normal + side * side + kNothing);
  if (!(-normal / distance >= kWrongSide))
    return {cone, lanes.s[cone], lanes.residual[cone], -1.0f, 0.0f};
  return {cone, lanes.s[cone], lanes.residual[cone], normal / distance, side / distance};
}

}  // namespace

PackedContourCones::PackedContourCones(const ContourWorldCones& cones) {
  for (int i = 0; i < kLanes; ++i) {
    const ContourWorldCone& cone = cones[size_t(i < kContourCones ? i : 0)];
    const Eigen::Vector3f a = cone.a.cast<float>(), axis = cone.b.cast<float>() - a;
    ax[i] = a.x(), ay[i] = a.y(), az[i] = a.z(), radius[i] = float(cone.radius_a);
    ux[i] = axis.x(), uy[i] = axis.y(), uz[i] = axis.z();
    taper[i] = float(cone.radius_b) - float(cone.radius_a);
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
    const int best = measure(cones[ray.camera],
                             {{ray.normal.x(), ray.normal.y(), ray.normal.z()},
                              {ray.side.x(), ray.side.y(), ray.side.z()},
                              ray.normal_of_ray,
                              ray.side_of_ray},
                             lanes);
    matches[r] = matchTo(best, lanes);
  }
}

}  // namespace markerless_mocap
