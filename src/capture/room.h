#pragma once

#include <Eigen/Core>

namespace markerless_mocap {

/// Colour (RGB, 0 to 1) of the empty room along a ray: a checkered floor at z = 0, a ceiling, four
/// walls about the ring of cameras, all with a fine static grain. \param eye inside the room,
/// metres
Eigen::Vector3d roomColor(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
                          const Eigen::Vector3d& half_size);

/// Half extents in x and y and the full height (z) of a room that holds a camera at `eye`.
Eigen::Vector3d roomAround(const Eigen::Vector3d& eye);

}  // namespace markerless_mocap
