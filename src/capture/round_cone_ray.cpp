#include "capture/round_cone_ray.h"

#include <cmath>

namespace markerless_mocap {

RoundConeCaster::RoundConeCaster(const SolidCone& cone, const Eigen::Vector3d& eye)
    : radius_a_(cone.radius_a),
      radius_b_(cone.radius_b),
      axis_(cone.b - cone.a),
      eye_a_(eye - cone.a),
      eye_b_(eye - cone.b) {
  const double taper = radius_a_ - radius_b_;
  slant_squared_ = axis_.squaredNorm() - taper * taper;
  has_side_ = slant_squared_ > 1e-12;
  axis_eye_ = axis_.dot(eye_a_);
}

void RoundConeCaster::hitSphere(const Eigen::Vector3d& eye, double radius,
                                const Eigen::Vector3d& direction,
                                std::optional<RayHit>& best) const {
  const double along = eye.dot(direction);
  const double discriminant = along * along - eye.squaredNorm() + radius * radius;
  if (discriminant < 0.0) return;
  const double distance = -along - std::sqrt(discriminant);
  if (distance <= 0.0 || (best && best->distance <= distance)) return;
  best = RayHit{distance, (eye + distance * direction) / radius};
}

void RoundConeCaster::hitSide(const Eigen::Vector3d& direction, std::optional<RayHit>& best) const {
  // With p = eye + t d seen from a, axis u, taper r = ra - rb, m = u.u, s = m - r^2: the side is
  //   s p.p - (u.p)^2 + 2 r ra (u.p) - m ra^2 = 0   between   0 < u.p - ra r < s.
  const double taper = radius_a_ - radius_b_;
  const double axis_direction = axis_.dot(direction);
  const double k2 = slant_squared_ - axis_direction * axis_direction;
  const double k1 = slant_squared_ * eye_a_.dot(direction) - axis_eye_ * axis_direction +
                    taper * radius_a_ * axis_direction;
  const double k0 = slant_squared_ * eye_a_.squaredNorm() - axis_eye_ * axis_eye_ +
                    2.0 * taper * radius_a_ * axis_eye_ -
                    axis_.squaredNorm() * radius_a_ * radius_a_;
  const double discriminant = k1 * k1 - k0 * k2;
  if (discriminant < 0.0 || std::abs(k2) < 1e-12) return;
  const double root = std::sqrt(discriminant);
  for (const double distance : {(-k1 - root) / k2, (-k1 + root) / k2}) {
    const double site = axis_eye_ - radius_a_ * taper + distance * axis_direction;
    if (distance <= 0.0 || site <= 0.0 || site >= slant_squared_) continue;
    if (best && best->distance <= distance) continue;
    const Eigen::Vector3d gradient =
        slant_squared_ * (eye_a_ + distance * direction) - site * axis_;
    best = RayHit{distance, gradient.normalized()};
  }
}

std::optional<RayHit> RoundConeCaster::cast(const Eigen::Vector3d& direction) const {
  std::optional<RayHit> best;
  hitSphere(eye_a_, radius_a_, direction, best);
  hitSphere(eye_b_, radius_b_, direction, best);
  if (has_side_) hitSide(direction, best);
  return best;
}

}  // namespace markerless_mocap
