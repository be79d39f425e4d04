#include "markerless_mocap/camera/camera.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr int kMaxPixels = 65536;  // along an edge of an image
constexpr double kMaxK = 1e7;      // pixels
constexpr double kFarthest = 1e4;  // of a camera from the origin on an axis, metres

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
  const double x = p.x(), y = p.y(), s = p.squaredNorm();
  const double radial = RadialFactor(k, s).value();
  return {x * radial + 2 * k[2] * x * y + k[3] * (s + 2 * x * x),
          y * radial + k[2] * (s + 2 * y * y) + 2 * k[3] * x * y};
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

[[noreturn]] void throwError(const std::string& name, const std::string& what) {
  throw std::invalid_argument("camera '" + name + "': " + what);
}

void validateIntrinsics(const CameraCalibration& c) {
  if (c.width <= 0 || c.height <= 0)
    throwError(c.name, "image size is " + std::to_string(c.width) + " x " +
                           std::to_string(c.height) + ", it must be at least 1 x 1");
  if (std::max(c.width, c.height) > kMaxPixels)
    throwError(c.name, "image size is " + std::to_string(c.width) + " x " +
                           std::to_string(c.height) + ", allowed are up to " +
                           std::to_string(kMaxPixels) + " pixels in a row or column");
  if (!c.K.allFinite()) throwError(c.name, "K holds a value that is not finite");
  if (c.K.isZero(0)) throwError(c.name, "K is all zero, so the camera is not calibrated");
  if (!(c.K(0, 0) > 0 && c.K(1, 1) > 0))
    throwError(c.name, "the focal lengths in K must be positive");
  if (c.K.cwiseAbs().maxCoeff() > kMaxK)
    throwError(c.name, "K holds a value above 10 million pixels");
  if (c.K(1, 0) != 0 || c.K.row(2) != Eigen::RowVector3d(0, 0, 1))
    throwError(c.name, "K must be upper triangular with a last row of 0 0 1");
  const size_t n = c.D.size();
  if (n != 0 && n != 4 && n != 5 && n != 8)
    throwError(c.name,
               "D has " + std::to_string(n) + " distortion coefficients, allowed are 0, 4, 5 or 8");
  for (const double d : c.D)
    if (!std::isfinite(d)) throwError(c.name, "D holds a value that is not finite");
}

/// The image-plane point of a pixel, before the distortion is removed.
Eigen::Vector2d distortedPlane(const Eigen::Matrix3d& K, const Eigen::Vector2d& pixel) {
  const double y = (pixel.y() - K(1, 2)) / K(1, 1);
  return {(pixel.x() - K(0, 2) - K(0, 1) * y) / K(0, 0), y};
}

/// Whether a point of the distorted image plane has a ray, and the lens moves it as lenses do.
bool isSeenByLens(const double (&k)[8], double max_radius_squared, const Eigen::Vector2d& distorted,
                  double tolerance) {
  constexpr double kMinScale = 0.05, kMaxScale = 3;  // distorted by undistorted radius
  const Eigen::Vector2d plane = undistort(k, max_radius_squared, distorted);
  const double from = plane.norm(), to = distorted.norm();
  return (distort(k, plane) - distorted).norm() < tolerance &&
         (to < tolerance || (to >= kMinScale * from && to <= kMaxScale * from));
}

/// A model that folds the image or blows it up is not of a lens. Those of wide lenses may fold in
/// the corners, where they were not measured.
void validateDistortion(const CameraCalibration& c) {
  constexpr int kColumns = 16, kRows = 12;
  constexpr int kMinPercent = 40;
  double k[8] = {};
  std::copy(c.D.begin(), c.D.end(), k);
  const double max_radius_squared = foldRadiusSquared(k);
  int seen = 0;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const Eigen::Vector2d pixel((column + 0.5) / kColumns * c.width - 0.5,
                                  (row + 0.5) / kRows * c.height - 0.5);
      seen += isSeenByLens(k, max_radius_squared, distortedPlane(c.K, pixel), 0.5 / c.K(0, 0));
    }
  if (const int percent = 100 * seen / (kColumns * kRows); percent < kMinPercent)
    throwError(c.name, "the distortion D is not of a lens: it can be removed in " +
                           std::to_string(percent) + " % of the image, allowed are " +
                           std::to_string(kMinPercent) + " % or more");
}

void validatePose(const CameraCalibration& c) {
  constexpr double kTolerance = 1e-6;
  const Eigen::Matrix4d& T = c.T_world_camera.matrix();
  if (!T.allFinite()) throwError(c.name, "the pose holds a value that is not finite");
  if (c.T_world_camera.translation().cwiseAbs().maxCoeff() > kFarthest)
    throwError(c.name, "the position is farther than 10 km from the origin of the world");
  const Eigen::Matrix3d R = T.topLeftCorner<3, 3>();
  if (!(R.transpose() * R).isIdentity(kTolerance) || R.determinant() < 0 ||
      T.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    throwError(c.name, "the pose is not a rigid transform (rotation and translation)");
}

}  // namespace

void CameraCalibration::validate() const {
  validateIntrinsics(*this);
  validateDistortion(*this);
  validatePose(*this);
  if (!std::isfinite(time_offset)) throwError(name, "the time offset is not finite");
}

Camera::Camera(CameraCalibration calibration) : calibration_(std::move(calibration)) {
  calibration_.validate();
  T_camera_world_ = calibration_.T_world_camera.inverse();
  std::copy(calibration_.D.begin(), calibration_.D.end(), k_);
  max_radius_squared_ = foldRadiusSquared(k_);
}

std::optional<Eigen::Vector2d> Camera::project(const Eigen::Vector3d& point_world) const {
  const Eigen::Vector3d p = T_camera_world_ * point_world;
  if (!(p.z() > 0)) return std::nullopt;
  const Eigen::Vector2d plane = p.head<2>() / p.z();
  if (!(plane.squaredNorm() < max_radius_squared_)) return std::nullopt;
  const Eigen::Vector3d distorted = distort(k_, plane).homogeneous();
  return Eigen::Vector2d(calibration_.K.topRows<2>() * distorted);
}

std::optional<Eigen::Vector2d> Camera::projectInside(const Eigen::Vector3d& point_world) const {
  const std::optional<Eigen::Vector2d> pixel = project(point_world);
  if (!pixel || !(pixel->x() >= -0.5 && pixel->x() < width() - 0.5 && pixel->y() >= -0.5 &&
                  pixel->y() < height() - 0.5))
    return std::nullopt;
  return pixel;
}

Eigen::Vector3d Camera::rayDirection(const Eigen::Vector2d& pixel) const {
  const Eigen::Matrix3d& K = calibration_.K;
  const Eigen::Vector2d plane = undistort(k_, max_radius_squared_, distortedPlane(K, pixel));
  return (calibration_.T_world_camera.linear() * plane.homogeneous()).normalized();
}

CameraCalibration decomposeProjection(const Eigen::Matrix<double, 3, 4>& P) {
  if (!P.allFinite())
    throw std::invalid_argument("projection matrix holds a value that is not finite");
  Eigen::Matrix3d M = P.leftCols<3>();
  const double scale = M.norm();
  const double determinant = M.determinant();
  if (!(std::abs(determinant) > 1e-12 * scale * scale * scale))
    throw std::invalid_argument(
        "projection matrix has a singular left 3x3 block, so it is no finite camera");
  // P is known up to a factor only. A positive determinant gives visible points a positive depth.
  const double sign = determinant > 0 ? 1 : -1;
  M *= sign;

  // RQ decomposition of M by QR of its transpose with reversed rows.
  const Eigen::Matrix3d reversal =
      Eigen::Vector3d::Ones().asDiagonal().toDenseMatrix().rowwise().reverse();
  const Eigen::HouseholderQR<Eigen::Matrix3d> qr((reversal * M).transpose());
  const Eigen::Matrix3d upper = qr.matrixQR().triangularView<Eigen::Upper>();
  const Eigen::Matrix3d Q = qr.householderQ();
  Eigen::Matrix3d K = reversal * upper.transpose() * reversal;
  Eigen::Matrix3d R = reversal * Q.transpose();
  const Eigen::Vector3d signs = K.diagonal().cwiseSign();
  K = K * signs.asDiagonal();
  R = signs.asDiagonal() * R;

  const Eigen::Vector3d t = K.triangularView<Eigen::Upper>().solve(sign * P.col(3));
  CameraCalibration calibration;
  calibration.K = (K / K(2, 2)).triangularView<Eigen::Upper>();
  calibration.K(2, 2) = 1;
  calibration.T_world_camera.linear() = R.transpose();
  calibration.T_world_camera.translation() = -R.transpose() * t;
  return calibration;
}

}  // namespace markerless_mocap
