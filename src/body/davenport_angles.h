#pragma once

#include <Eigen/Core>
#include <array>

namespace markerless_mocap {

/// Davenport angles t of a rotation, radians: R = exp(axes[0] t0) exp(axes[1] t1) exp(axes[2] t2).
/// Neighbouring axes must be perpendicular unit vectors. There are two solutions, each up to full
/// turns. Solutions with the middle angle inside its limits are preferred, then the one nearest to
/// `near` is returned. If only a sum of the outer angles is defined, the first one keeps its value.
Eigen::Vector3d davenportAngles(const Eigen::Matrix3d& R,
                                const std::array<Eigen::Vector3d, 3>& axes,
                                const Eigen::Vector3d& near, double middle_lower,
                                double middle_upper);

}  // namespace markerless_mocap
