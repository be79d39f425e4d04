#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// A point of the body, marked in the image of one camera.
struct PointMark {
  const Camera* camera;
  Eigen::Vector2d pixel;
};

/// The point with the least squared distances, in pixels, from the rays of its marks.
/// \param marks at least one
Eigen::Vector3d meetingPoint(const std::vector<PointMark>& marks);

/// What a mark with an error of 1 px tells about a point, 1/m^2.
Eigen::Matrix3d informationOf(const PointMark& mark, const Eigen::Vector3d& point);

/// Distance of a mark from the projected point, pixels; infinity if the camera does not see it.
double residualOf(const PointMark& mark, const Eigen::Vector3d& point);

/// Leaves out the mark without which the others agree best, until they agree within the limit.
/// \return the marks that were left out; all if fewer than two agree
std::vector<PointMark> leaveOutDisagreeing(double limit_px, std::vector<PointMark>* marks);

}  // namespace markerless_mocap
