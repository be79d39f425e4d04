#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace markerless_mocap {

/// OpenCV's two families of lenses.
enum class LensType {
  kPolynomial,  ///< sensor_msgs plumb_bob and rational_polynomial
  kFisheye      ///< cv::fisheye, sensor_msgs equidistant: Kannala and Brandt (2006)
};

/// Calibration of one camera: pinhole model with lens distortion, and pose in the world.
struct CameraCalibration {
  std::string name;
  int width = 0;                                ///< pixels
  int height = 0;                               ///< pixels
  Eigen::Matrix3d K = Eigen::Matrix3d::Zero();  ///< pixels; pixel centres have integer coordinates
  /// Distortion, OpenCV order k1 k2 p1 p2 [k3 [k4 k5 k6]]; empty, 4, 5 or 8 values. Of a fisheye
  /// k1 k2 k3 k4; empty or 4 values.
  std::vector<double> D;
  LensType lens = LensType::kPolynomial;
  /// Optical frame (x right, y down, z forward; REP-103) to world, metres.
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  double time_offset = 0.0;  ///< s, to be added to the camera's stamps for the rig's common time

  /// Throws std::invalid_argument on a size above 65536, a non-finite K, a D that cannot be removed
  /// in most of the image, a pose that is not rigid or beyond 10 km, or a time offset that is not
  /// finite. The message names the camera.
  void validate() const;
};

/// A lens in the form that projections need.
struct LensNumbers {
  LensType type = LensType::kPolynomial;
  double k[8] = {};  ///< as CameraCalibration::D, missing coefficients zero
  /// How far from the axis the model is monotonic: the squared radius of undistorted image-plane
  /// points; of a fisheye the angle, rad.
  double reach = 0.0;
};

/// A pinhole camera at the place of another one. Near the point for which it was made it shows
/// sizes as the other one does; distortion is left out.
struct LocalView {
  Eigen::Matrix3d R_world_view;  ///< x and y as in the image, z forward
  double fx, fy;                 ///< pixels
};

/// Projects points with the full lens model. Immutable; may be shared by threads.
class Camera {
 public:
  /// Throws std::invalid_argument as CameraCalibration::validate().
  explicit Camera(CameraCalibration calibration);

  const CameraCalibration& calibration() const { return calibration_; }
  const std::string& name() const { return calibration_.name; }
  int width() const { return calibration_.width; }
  int height() const { return calibration_.height; }
  Eigen::Vector3d position() const { return calibration_.T_world_camera.translation(); }

  /// Projects a world point (metres) to a pixel. Empty if the point is behind the camera (a fisheye
  /// may see it), or so far from the optical axis that the distortion polynomial is no longer
  /// monotonic. The pixel may lie outside the image.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_world) const;

  /// As project(), but also empty if the nearest pixel is not in the image.
  std::optional<Eigen::Vector2d> projectInside(const Eigen::Vector3d& point_world) const;

  /// A world point in the optical frame, metres.
  Eigen::Vector3d inCameraFrame(const Eigen::Vector3d& point_world) const {
    return T_camera_world_ * point_world;
  }
  /// As project(), of a point in the optical frame.
  std::optional<Eigen::Vector2d> projectFromCameraFrame(const Eigen::Vector3d& in_camera) const;
  /// Whether the nearest pixel is in the image.
  bool isInImage(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.x() < width() - 0.5 && pixel.y() >= -0.5 &&
           pixel.y() < height() - 0.5;
  }

  /// Unit direction in the world of the viewing ray through a pixel, with distortion removed.
  Eigen::Vector3d rayDirection(const Eigen::Vector2d& pixel) const;

  /// The view of what is near a point. For polynomial lenses it is K and the axes of this camera
  /// everywhere; for a fisheye the view looks at the point. \param point_world not the camera's own
  /// position
  LocalView localView(const Eigen::Vector3d& point_world) const;

  /// How large a metre across the line of sight is shown, pixels. \param in_camera a point that the
  /// camera sees, in the optical frame
  double pixelsPerMetre(const Eigen::Vector3d& in_camera) const;

 private:
  CameraCalibration calibration_;
  Eigen::Isometry3d T_camera_world_;
  LensNumbers lens_;
};

using CameraRig = std::vector<Camera>;

/// Splits a 3x4 projection matrix P = K [R | t] by RQ decomposition into K (positive diagonal,
/// K(2,2) = 1) and the camera's pose. Source: Hartley and Zisserman, Multiple View Geometry, 6.2.4.
/// Throws std::invalid_argument if the left 3x3 block is singular or not finite.
CameraCalibration decomposeProjection(const Eigen::Matrix<double, 3, 4>& P);

}  // namespace markerless_mocap
