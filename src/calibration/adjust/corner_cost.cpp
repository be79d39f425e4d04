#include "calibration/adjust/corner_cost.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

/// A rotation by its vector, and how a rotated point changes with the vector.
struct Turn {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d right_jacobian = Eigen::Matrix3d::Identity();

  explicit Turn(const double* vector) {
    const Eigen::Map<const Eigen::Vector3d> v(vector);
    const double angle = v.norm();
    const Eigen::Matrix3d K = crossMatrix(v);
    if (angle < 1e-6) {
      R += K;
      right_jacobian -= 0.5 * K;
      return;
    }
    const Eigen::Matrix3d KK = K * K;
    const double s = std::sin(angle) / angle, c = (1 - std::cos(angle)) / (angle * angle);
    R += s * K + c * KK;
    right_jacobian += -c * K + (1 - s) / (angle * angle) * KK;
  }

  Eigen::Matrix3d slope(const Eigen::Vector3d& point) const {
    return -R * crossMatrix(point) * right_jacobian;
  }
};

template <int kColumns>
using Slopes = Eigen::Map<
    Eigen::Matrix<double, 2, kColumns, kColumns == 1 ? Eigen::ColMajor : Eigen::RowMajor>>;

template <int kColumns>
Slopes<kColumns> slopesAt(double* jacobian) {
  return Slopes<kColumns>(jacobian);
}

PixelSlopes polynomialSlopes(const double* in, const Eigen::Vector3d& p) {
  const double *k = in + 4, iz = 1 / p.z(), x = p.x() * iz, y = p.y() * iz, s = x * x + y * y;
  const double N = 1 + s * (k[0] + s * (k[1] + s * k[4]));
  const double D = 1 + s * (k[5] + s * (k[6] + s * k[7]));
  const double radial = N / D;
  const double slope = (k[0] + s * (2 * k[1] + 3 * s * k[4])) / D -
                       radial * (k[5] + s * (2 * k[6] + 3 * s * k[7])) / D;
  const double cross = 2 * x * y * slope + 2 * k[2] * x + 2 * k[3] * y;
  Eigen::Matrix2d plane;  // derivative of the distorted point
  plane << radial + 2 * x * x * slope + 2 * k[2] * y + 6 * k[3] * x, cross, cross,
      radial + 2 * y * y * slope + 6 * k[2] * y + 2 * k[3] * x;
  const Eigen::Vector2d focal(in[0], in[1]), xy(x, y);
  Eigen::Matrix<double, 2, 3> on_plane;
  on_plane << iz, 0, -x * iz, 0, iz, -y * iz;
  PixelSlopes slopes;
  slopes.point = focal.asDiagonal() * plane * on_plane;
  slopes.intrinsics.setZero();
  slopes.intrinsics(0, 0) = x * radial + 2 * k[2] * x * y + k[3] * (s + 2 * x * x);
  slopes.intrinsics(1, 1) = y * radial + k[2] * (s + 2 * y * y) + 2 * k[3] * x * y;
  slopes.intrinsics(0, 2) = slopes.intrinsics(1, 3) = 1;
  Eigen::Matrix<double, 2, 8> lens;
  const Eigen::Vector2d up = xy / D, down = -xy * radial / D;
  lens << up * s, up * (s * s), Eigen::Vector2d(2 * x * y, s + 2 * y * y),
      Eigen::Vector2d(s + 2 * x * x, 2 * x * y), up * (s * s * s), down * s, down * (s * s),
      down * (s * s * s);
  slopes.intrinsics.rightCols<8>() = focal.asDiagonal() * lens;
  return slopes;
}

/// OpenCV's fisheye: a point's angle to the axis gives its radius.
PixelSlopes fisheyeSlopes(const double* in, const Eigen::Vector3d& p) {
  const double* k = in + 4;
  const Eigen::Vector2d focal(in[0], in[1]), across = p.head<2>();
  const double r = std::max(across.norm(), 1e-12), angle = std::atan2(r, p.z()), s = angle * angle;
  const double radius = angle * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
  const double slope = 1 + s * (3 * k[0] + s * (5 * k[1] + s * (7 * k[2] + s * 9 * k[3])));
  const Eigen::Vector2d outward = across / r;
  const Eigen::Matrix2d radial = outward * outward.transpose();
  const double around = r > 1e-9 ? radius / r : 1 / p.z(), squared = p.squaredNorm();
  Eigen::Matrix<double, 2, 3> plane;  // derivative of the distorted point
  plane.leftCols<2>() =
      around * Eigen::Matrix2d::Identity() + (slope * p.z() / squared - around) * radial;
  plane.col(2) = -slope * r / squared * outward;
  PixelSlopes slopes;
  slopes.point = focal.asDiagonal() * plane;
  slopes.intrinsics.setZero();
  slopes.intrinsics(0, 0) = around * across.x();
  slopes.intrinsics(1, 1) = around * across.y();
  slopes.intrinsics(0, 2) = slopes.intrinsics(1, 3) = 1;
  for (int i = 0; i < 4; ++i)
    slopes.intrinsics.col(4 + i) = focal.asDiagonal() * outward * std::pow(angle, 2 * i + 3);
  return slopes;
}

}  // namespace

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

PixelSlopes pixelSlopes(LensType lens, const double* in, const Eigen::Vector3d& p) {
  return lens == LensType::kFisheye ? fisheyeSlopes(in, p) : polynomialSlopes(in, p);
}

bool CornerCost::Evaluate(double const* const* parameters, double* residuals,
                          double** jacobians) const {
  if (!corner_(parameters[0], parameters[1], parameters[2], parameters[3], residuals)) return false;
  if (!jacobians) return true;
  const Turn camera(parameters[1]), board(parameters[2]);
  const Eigen::Map<const Eigen::Vector3d> camera_at(parameters[1] + 3), board_at(parameters[2] + 3);
  const Eigen::Vector3d on_board(corner_.place.x(), corner_.place.y(), 0);
  const Eigen::Vector3d world = board.R * on_board + board_at;
  const PixelSlopes pixel = pixelSlopes(corner_.lens, parameters[0], camera.R * world + camera_at);
  if (jacobians[0]) slopesAt<12>(jacobians[0]) = pixel.intrinsics;
  if (jacobians[1]) {
    Slopes<6> J = slopesAt<6>(jacobians[1]);
    J.leftCols<3>() = pixel.point * camera.slope(world);
    J.rightCols<3>() = pixel.point;
  }
  if (jacobians[2]) {
    const Eigen::Matrix<double, 2, 3> to_world = pixel.point * camera.R;
    Slopes<6> J = slopesAt<6>(jacobians[2]);
    J.leftCols<3>() = to_world * board.slope(on_board);
    J.rightCols<3>() = to_world;
  }
  if (jacobians[3])
    slopesAt<1>(jacobians[3]) =
        corner_.motion.velocity + (corner_.lag - parameters[3][0]) * corner_.motion.acceleration;
  return true;
}

}  // namespace markerless_mocap
