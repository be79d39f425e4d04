#include "markerless_mocap/camera/camera.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "camera/lens_distortion.h"
#include "numerics/shortest_rotation.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

constexpr int kMaxPixels = 65536;  // along an edge of an image
constexpr double kMaxK = 1e7;      // pixels
constexpr double kFarthest = 1e4;  // of a camera from the origin on an axis, metres

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
  const bool fisheye = c.lens == LensType::kFisheye;
  if (n != 0 && n != 4 && (fisheye || (n != 5 && n != 8)))
    throwError(c.name, "D has " + std::to_string(n) + " distortion coefficients, allowed are " +
                           (fisheye ? "0 or 4 of a fisheye" : "0, 4, 5 or 8"));
  for (const double d : c.D)
    if (!std::isfinite(d)) throwError(c.name, "D holds a value that is not finite");
}

/// The image-plane point of a pixel, before the distortion is removed.
Eigen::Vector2d distortedPlane(const Eigen::Matrix3d& K, const Eigen::Vector2d& pixel) {
  const double y = (pixel.y() - K(1, 2)) / K(1, 1);
  return {(pixel.x() - K(0, 2) - K(0, 1) * y) / K(0, 0), y};
}

/// No lens shows what K makes of the image: nearly nothing, or what lies beside the camera. A
/// principal point outside of an image that was cut out of a larger one is allowed.
void validateView(const CameraCalibration& c) {
  constexpr double kNarrowest = 0.005;  // rad, the longer side of the image
  constexpr double kWidest = 80.0;      // degrees from the axis, without distortion
  constexpr double kFisheyeWidest = 240.0;
  constexpr double kDegrees = 180.0 / M_PI;
  const double view = std::max(c.width / c.K(0, 0), c.height / c.K(1, 1));
  if (view < kNarrowest)
    throwError(c.name, "the focal lengths in K, " + numbersText(std::array{c.K(0, 0), c.K(1, 1)}) +
                           " pixels, are more than 200 times the size of the image");
  const double right = c.width - 1.0, bottom = c.height - 1.0;
  double angle = 0.0;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, 0), {right, 0}, {0, bottom}, {right, bottom}}) {
    const double radius = distortedPlane(c.K, corner).norm();
    angle = std::max(angle, c.lens == LensType::kFisheye ? radius : std::atan(radius));
  }
  const double widest = c.lens == LensType::kFisheye ? kFisheyeWidest : kWidest;
  if (angle * kDegrees > widest)
    throwError(c.name,
               "by K, with the focal lengths " + numbersText(std::array{c.K(0, 0), c.K(1, 1)}) +
                   " and the principal point " + numbersText(std::array{c.K(0, 2), c.K(1, 2)}) +
                   ", a corner of the image is " + std::to_string(std::lround(angle * kDegrees)) +
                   " degrees off the axis of the lens, allowed are " +
                   std::to_string(std::lround(widest)));
}

/// A model that folds the image or blows it up is not of a lens. Those of wide lenses may fold in
/// the corners, where they were not measured.
void validateDistortion(const CameraCalibration& c) {
  constexpr int kColumns = 16, kRows = 12;
  constexpr int kMinPercent = 40;
  const LensNumbers lens = lensNumbersOf(c);
  int seen = 0;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const Eigen::Vector2d pixel((column + 0.5) / kColumns * c.width - 0.5,
                                  (row + 0.5) / kRows * c.height - 0.5);
      seen += isSeenByLens(lens, distortedPlane(c.K, pixel), 0.5 / c.K(0, 0));
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
  validateView(*this);
  validateDistortion(*this);
  validatePose(*this);
  if (!std::isfinite(time_offset)) throwError(name, "the time offset is not finite");
}

Camera::Camera(CameraCalibration calibration) : calibration_(std::move(calibration)) {
  calibration_.validate();
  T_camera_world_ = calibration_.T_world_camera.inverse();
  lens_ = lensNumbersOf(calibration_);
}

std::optional<Eigen::Vector2d> Camera::project(const Eigen::Vector3d& point_world) const {
  return projectFromCameraFrame(inCameraFrame(point_world));
}

std::optional<Eigen::Vector2d> Camera::projectFromCameraFrame(
    const Eigen::Vector3d& in_camera) const {
  const std::optional<Eigen::Vector2d> plane = distortedPoint(lens_, in_camera);
  if (!plane) return std::nullopt;
  const Eigen::Vector3d distorted = plane->homogeneous();
  return Eigen::Vector2d(calibration_.K.topRows<2>() * distorted);
}

std::optional<Eigen::Vector2d> Camera::projectInside(const Eigen::Vector3d& point_world) const {
  const std::optional<Eigen::Vector2d> pixel = project(point_world);
  return pixel && isInImage(*pixel) ? pixel : std::nullopt;
}

Eigen::Vector3d Camera::rayDirection(const Eigen::Vector2d& pixel) const {
  const Eigen::Matrix3d& K = calibration_.K;
  const Eigen::Vector3d in_camera = undistortedDirection(lens_, distortedPlane(K, pixel));
  return (calibration_.T_world_camera.linear() * in_camera).normalized();
}

LocalView Camera::localView(const Eigen::Vector3d& point_world) const {
  const Eigen::Matrix3d& K = calibration_.K;
  LocalView view{calibration_.T_world_camera.linear(), K(0, 0), K(1, 1)};
  if (lens_.type == LensType::kPolynomial) return view;
  const Eigen::Vector3d in_camera = inCameraFrame(point_world);
  view.R_world_view = view.R_world_view * shortestRotation(Eigen::Vector3d::UnitZ(), in_camera);
  const double scale = fisheyeScale(lens_, in_camera);
  view.fx *= scale;
  view.fy *= scale;
  return view;
}

double Camera::pixelsPerMetre(const Eigen::Vector3d& in_camera) const {
  const double f = 0.5 * (calibration_.K(0, 0) + calibration_.K(1, 1));
  if (lens_.type == LensType::kPolynomial) return f / in_camera.z();
  return f * fisheyeScale(lens_, in_camera) / in_camera.norm();
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
