#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "calibration/adjust/residuals.h"
#include "calibration/lens.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// A camera while it is estimated.
struct CameraState {
  Intrinsics intrinsics{};
  LensModel lens = LensModel::kPlumbBob;
  bool intrinsics_fixed = false;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();  ///< pixels, of the image; 0: not known
  PoseVector camera_world = PoseVector::Zero();
  bool located = false;      ///< its pose is known
  double time_offset = 0.0;  ///< s, to be added to the camera's clock
};

/// One corner of a view.
struct CornerSight {
  int id = 0;
  Eigen::Vector2d pixel;
  CornerMotion motion;
  bool used = true;  ///< false: an outlier
};

/// One view within an instant.
struct ViewSight {
  size_t camera = 0;
  size_t view = 0;    ///< index of the BoardView
  double time = 0.0;  ///< s, clock of the camera
  std::vector<CornerSight> corners;
  bool used = true;  ///< false: the camera stood elsewhere at that time
};

/// The views of one time, which share a pose of the board.
struct Instant {
  double time = 0.0;  ///< s
  std::vector<ViewSight> views;
  PoseVector world_board = PoseVector::Zero();
  bool located = false;  ///< its pose is known
};

/// All that is estimated together, and what it is estimated from.
struct RigState {
  std::vector<CameraState> cameras;
  std::vector<Instant> instants;
  std::vector<KnownPoint> points;
  double corner_sigma = 0.3;  ///< pixels, of one coordinate of a corner
  /// Pixels: the noise that corners would have, were those of a view independent, for lenses to be
  /// as uncertain as the scatter of whole views shows. By it corners count against what is known of
  /// lenses beforehand.
  double view_sigma = 0.3;
  double point_sigma = 3.0;  ///< pixels, of one coordinate of a point that states none
};

inline double sigmaOf(const RigState& state, const KnownPoint& point) {
  return point.sigma > 0 ? point.sigma : state.point_sigma;
}

/// Scale of the robust loss of points (Cauchy), in standard deviations of a coordinate.
constexpr double kPointLoss = 6.0;

inline PoseVector poseVector(const Eigen::Isometry3d& T) {
  const Eigen::AngleAxisd turn(T.linear());
  PoseVector v;
  v << turn.angle() * turn.axis(), T.translation();
  return v;
}

inline Eigen::Isometry3d isometry(const PoseVector& v) {
  const Eigen::Vector3d turn = v.head<3>();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  if (turn.norm() > 0)
    T.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  T.translation() = v.tail<3>();
  return T;
}

/// Residual of one corner, pixels; NaN if the corner is behind the camera.
inline Eigen::Vector2d residualOf(const RigState& state, const Board& board, const Instant& instant,
                                  const ViewSight& view, const CornerSight& corner) {
  const CameraState& camera = state.cameras[view.camera];
  const CornerResidual residual{board.corners()[corner.id], corner.pixel, corner.motion,
                                instant.time - view.time, typeOf(camera.lens)};
  Eigen::Vector2d out;
  if (!residual(camera.intrinsics.data(), camera.camera_world.data(), instant.world_board.data(),
                &camera.time_offset, out.data()))
    out.setConstant(NAN);
  return out;
}

}  // namespace markerless_mocap
