#pragma once

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <vector>

namespace markerless_mocap {

struct Surface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 4>> quads;  ///< counter-clockwise from outside
};

/// The zero surface of a signed distance that is mirror-symmetric in y. The surface is closed: each
/// edge belongs to two quads. Surface nets (Gibson 1998) on a lattice; each vertex is then smoothed
/// among its neighbours and moved along the gradient onto the surface.
/// \param field signed distance, metres; called from several threads
/// \param box bounds of the surface; mirrored in y
/// \param pitch of the lattice, metres
Surface surfaceOf(const std::function<double(const Eigen::Vector3d&)>& field,
                  const Eigen::AlignedBox3d& box, double pitch);

}  // namespace markerless_mocap
