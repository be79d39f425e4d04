#include "camera/lens_distortion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "camera/lens_equations.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxAngle = 3.1;  // to the axis of a fisheye, rad

/// The radial factor (1 + k1 s + k2 s^2 + k3 s^3) / (1 + k4 s + k5 s^2 + k6 s^3) of s = r^2.
struct RadialFactor {
  double numerator, denominator;
  double numerator_slope, denominator_slope;  ///< derivatives with respect to s

  RadialFactor(const double (&k)[8], double s)
      : numerator(1 + s * (k[0] + s * (k[1] + s * k[4]))),
        denominator(1 + s * (k[5] + s * (k[6] + s * k[7]))),
        numerator_slope(k[0] + s * (2 * k[1] + 3 * s * k[4])),
        denominator_slope(k[5] + s * (2 * k[6] + 3 * s * k[7])) {}

  double value() const { return numerator / denominator; }
  double slope() const {
    return (numerator_slope * denominator - numerator * denominator_slope) /
           (denominator * denominator);
  }
  /// Whether the distorted radius r * value(r^2) grows with r at s.
  bool grows(double s) const {
    return denominator > 0 &&
           numerator * denominator +
                   2 * s * (numerator_slope * denominator - numerator * denominator_slope) >
               0;
  }
};

/// Maps an undistorted image-plane point to the distorted one.
Eigen::Vector2d distort(const double (&k)[8], const Eigen::Vector2d& p) {
  Eigen::Vector2d out;
  distortPolynomial(k, p.x(), p.y(), out.data());
  return out;
}

Eigen::Matrix2d distortionJacobian(const double (&k)[8], const Eigen::Vector2d& p) {
  const RadialFactor radial(k, p.squaredNorm());
  const double cross = 2 * k[2] * p.x() + 2 * k[3] * p.y();
  Eigen::Matrix2d tangential;
  tangential << 2 * k[2] * p.y() + 6 * k[3] * p.x(), cross, cross,
      6 * k[2] * p.y() + 2 * k[3] * p.x();
  return radial.value() * Eigen::Matrix2d::Identity() + 2 * radial.slope() * p * p.transpose() +
         tangential;
}

/// Squared radius up to which the distorted radius grows; infinity if it always grows.
double foldRadiusSquared(const double (&k)[8]) {
  const auto grows = [&](double r) { return RadialFactor(k, r * r).grows(r * r); };
  constexpr double kMaxRadius = 100;  // 89.4 degrees off the axis
  double inside = 0;
  while (inside < kMaxRadius) {
    double outside = inside + 1e-3 * std::max(1.0, inside);
    if (grows(outside)) {
      inside = outside;
      continue;
    }
    for (int i = 0; i < 50; ++i) {
      const double middle = (inside + outside) / 2;
      (grows(middle) ? inside : outside) = middle;
    }
    return inside * inside;
  }
  return std::numeric_limits<double>::infinity();
}

/// Inverts distort() by Newton's method inside the radius where it is invertible.
Eigen::Vector2d undistort(const double (&k)[8], double max_radius_squared,
                          const Eigen::Vector2d& distorted) {
  // Slightly inside the maximum radius, where the Jacobian is singular.
  const double max_radius = std::sqrt(max_radius_squared) * (1 - 1e-6);
  const auto clamped = [&](const Eigen::Vector2d& p) {
    const double r = p.norm();
    return Eigen::Vector2d(r > max_radius ? p * (max_radius / r) : p);
  };
  Eigen::Vector2d p = clamped(distorted);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector2d residual = distorted - distort(k, p);
    const Eigen::Vector2d next = clamped(p + distortionJacobian(k, p).inverse() * residual);
    const bool converged = (next - p).squaredNorm() < 1e-24;
    p = next;
    if (converged) break;
  }
  return p;
}

/// The radius at which a fisheye shows an angle, and its derivative.
struct FisheyeRadius {
  double value, slope;

  FisheyeRadius(const double (&k)[8], double angle) {
    const double s = angle * angle;
    value = angle * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
    slope = 1 + s * (3 * k[0] + s * (5 * k[1] + s * (7 * k[2] + s * 9 * k[3])));
  }
};

/// Angle up to which the radius grows.
double foldAngle(const double (&k)[8]) {
  constexpr double kStep = 1e-3;
  double angle = 0;
  while (angle + kStep < kMaxAngle && FisheyeRadius(k, angle + kStep).slope > 0) angle += kStep;
  return angle;
}

/// Newton's method between bounds that close in.
double angleAt(const double (&k)[8], double reach, double radius) {
  double low = 0, high = reach, angle = std::min(radius, 0.5 * reach);
  for (int i = 0; i < 60; ++i) {
    const FisheyeRadius at(k, angle);
    (at.value < radius ? low : high) = angle;
    double next = angle + (radius - at.value) / at.slope;
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const bool converged = std::abs(next - angle) < 1e-14;
    angle = next;
    if (converged) break;
  }
  return angle;
}

double angleOf(const Eigen::Vector3d& in_camera) {
  return std::atan2(in_camera.head<2>().norm(), in_camera.z());
}

}  // namespace

LensNumbers lensNumbersOf(const CameraCalibration& calibration) {
  LensNumbers lens;
  lens.type = calibration.lens;
  std::copy(calibration.D.begin(), calibration.D.end(), lens.k);
  lens.reach = lens.type == LensType::kFisheye ? foldAngle(lens.k) : foldRadiusSquared(lens.k);
  return lens;
}

std::optional<Eigen::Vector2d> distortedPoint(const LensNumbers& lens, const Eigen::Vector3d& p) {
  if (lens.type == LensType::kFisheye) {
    if (!(angleOf(p) < lens.reach) || p.isZero(0)) return std::nullopt;
    Eigen::Vector2d out;
    distortFisheye(lens.k, p.data(), out.data());
    return out;
  }
  if (!(p.z() > 0)) return std::nullopt;
  const Eigen::Vector2d plane = p.head<2>() / p.z();
  if (!(plane.squaredNorm() < lens.reach)) return std::nullopt;
  return distort(lens.k, plane);
}

Eigen::Vector3d undistortedDirection(const LensNumbers& lens, const Eigen::Vector2d& distorted) {
  if (lens.type == LensType::kPolynomial)
    return undistort(lens.k, lens.reach, distorted).homogeneous();
  const double radius = distorted.norm();
  if (!(radius > 0)) return Eigen::Vector3d::UnitZ();
  const double angle = angleAt(lens.k, lens.reach, radius);
  Eigen::Vector3d direction;
  direction << distorted * (std::sin(angle) / radius), std::cos(angle);
  return direction;
}

bool isSeenByLens(const LensNumbers& lens, const Eigen::Vector2d& distorted, double tolerance) {
  constexpr double kMinScale = 0.05, kMaxScale = 3;  // distorted by undistorted radius
  const Eigen::Vector3d direction = undistortedDirection(lens, distorted);
  const std::optional<Eigen::Vector2d> again = distortedPoint(lens, direction);
  const bool fisheye = lens.type == LensType::kFisheye;
  const double from = fisheye ? angleOf(direction) : direction.hnormalized().norm();
  const double to = distorted.norm();
  return again && (*again - distorted).norm() < tolerance &&
         (to < tolerance || (to >= kMinScale * from && to <= kMaxScale * from));
}

double fisheyeScale(const LensNumbers& lens, const Eigen::Vector3d& in_camera) {
  const double angle = std::min(angleOf(in_camera), lens.reach);
  if (angle < 1e-6) return 1.0;
  const FisheyeRadius radius(lens.k, angle);
  return std::sqrt(std::max(0.0, radius.slope) * radius.value / std::sin(angle));
}

}  // namespace markerless_mocap
