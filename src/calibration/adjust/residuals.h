#pragma once

#include <ceres/rotation.h>

#include <Eigen/Core>

#include "camera/lens_equations.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// A rotation vector (rad) and a translation (m).
using PoseVector = Eigen::Matrix<double, 6, 1>;

/// Pixel of a point in the camera's frame; the lens models of Camera.
template <class T>
void projectPoint(LensType lens, const T* intrinsics, const T* p, T* pixel) {
  T plane[2];
  if (lens == LensType::kFisheye)
    distortFisheye(intrinsics + 4, p, plane);
  else
    distortPolynomial(intrinsics + 4, T(p[0] / p[2]), T(p[1] / p[2]), plane);
  for (int i = 0; i < 2; ++i) pixel[i] = intrinsics[i] * plane[i] + intrinsics[2 + i];
}

/// Whether a lens may see a point in the camera's frame. A fisheye sees all but what is straight
/// behind it.
template <class T>
bool maySee(LensType lens, const T* p) {
  if (p[2] > T(1e-6)) return true;
  return lens == LensType::kFisheye && p[0] * p[0] + p[1] * p[1] > T(1e-6) + T(0.01) * p[2] * p[2];
}

template <class T>
void transformPoint(const T* pose, const T* point, T* out) {
  ceres::AngleAxisRotatePoint(pose, point, out);
  for (int i = 0; i < 3; ++i) out[i] += pose[3 + i];
}

/// How a corner moves in the image around the time of its view.
struct CornerMotion {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();      ///< pixels/s
  Eigen::Vector2d acceleration = Eigen::Vector2d::Zero();  ///< pixels/s^2
};

/// A corner of a board seen by a camera; the corner is moved to the time of the board's pose.
struct CornerResidual {
  Eigen::Vector2d place;  ///< m, on the board
  Eigen::Vector2d pixel;
  CornerMotion motion;
  double lag = 0.0;  ///< s: time of the board's pose minus the camera's clock at the view
  LensType lens = LensType::kPolynomial;

  /// \param offset s, to be added to the camera's clock
  template <class T>
  bool operator()(const T* intrinsics, const T* camera_world, const T* world_board, const T* offset,
                  T* residual) const {
    const T on_board[3] = {T(place.x()), T(place.y()), T(0)};
    T world[3], in_camera[3], projected[2];
    transformPoint(world_board, on_board, world);
    transformPoint(camera_world, world, in_camera);
    if (!maySee(lens, in_camera)) return false;
    projectPoint(lens, intrinsics, in_camera, projected);
    const T after = T(lag) - offset[0];
    for (int i = 0; i < 2; ++i)
      residual[i] =
          projected[i] -
          (T(pixel[i]) + after * (T(motion.velocity[i]) + T(0.5 * motion.acceleration[i]) * after));
    return true;
  }
};

/// A known point of the world seen by a camera.
struct PointResidual {
  Eigen::Vector3d position;
  Eigen::Vector2d pixel;
  LensType lens = LensType::kPolynomial;

  template <class T>
  bool operator()(const T* intrinsics, const T* camera_world, T* residual) const {
    const T world[3] = {T(position.x()), T(position.y()), T(position.z())};
    T in_camera[3], projected[2];
    transformPoint(camera_world, world, in_camera);
    if (!maySee(lens, in_camera)) return false;
    projectPoint(lens, intrinsics, in_camera, projected);
    for (int i = 0; i < 2; ++i) residual[i] = projected[i] - T(pixel[i]);
    return true;
  }
};

}  // namespace markerless_mocap
