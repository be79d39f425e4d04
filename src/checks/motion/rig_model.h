#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "checks/motion/person_track.h"

namespace markerless_mocap {

/// A camera as it may truly be: its calibration, which images are its own, and its clock.
struct CameraModel {
  CameraCalibration calibration;
  size_t source = 0;  ///< number of the track that its images are
  ImageTurn turn = ImageTurn::kNone;
  double offset = 0;  ///< s, added to its stamps
  double drift = 0;   ///< s per s, of its stamps since the first
};
using RigModel = std::vector<CameraModel>;

/// A line of sight to a mark. Pixels are those of an image of 640 pixels, see kModelWidth.
struct Ray {
  Eigen::Vector3d origin, direction;  ///< world metres, unit vector
  double focal = 0;                   ///< pixels per radian
};
constexpr double kModelWidth = 640;   ///< residuals are in pixels of an image of this width
constexpr double kResidualScale = 6;  ///< px; larger residuals count less and less

/// The rays of all cameras to one mark at one time; none where a camera does not see it.
using Rays = std::vector<std::optional<Ray>>;

/// The tracks of all cameras and the times at which they are compared.
struct RigSight {
  std::vector<PersonTrack> tracks;
  std::vector<double> moments;  ///< s, as PersonTrack::seconds
};

/// The rays of a camera to all marks at all moments: [moment * kBodyMarks + mark].
Rays raysOf(const RigSight& sight, const CameraModel& camera);
/// The same with sightOf() of the camera's track.
Rays raysOf(const RigSight& sight, const CameraModel& camera, const Sight& pixels);

/// Angle between a ray and the direction to a point, in pixels of kModelWidth.
double residualOf(const Ray& ray, const Eigen::Vector3d& point);
/// r^2 / (r^2 + kResidualScale^2), from 0 to 1 (Geman and McClure 1987).
double lossOf(double residual);

/// A point near most rays: the pair of rays whose point has the least loss, then refined. None if
/// there are less than two rays. \param left_out cameras that are passed over
std::optional<Eigen::Vector3d> pointOf(const std::vector<Rays>& rays, size_t at,
                                       const std::vector<size_t>& left_out);

/// Points for all moments and marks.
std::vector<std::optional<Eigen::Vector3d>> pointsOf(const std::vector<Rays>& rays,
                                                     const std::vector<size_t>& left_out);

/// Mean loss of the rays of one camera against points; 1 where a ray or all points are missing.
struct CameraLoss {
  double loss = 1;
  double residual = 0;  ///< median, px of kModelWidth
  int rays = 0;
};
CameraLoss lossOf(const Rays& rays, const std::vector<std::optional<Eigen::Vector3d>>& points);

/// Mean loss of the rays of all cameras against the points of all.
double lossOf(const std::vector<Rays>& rays);

}  // namespace markerless_mocap
