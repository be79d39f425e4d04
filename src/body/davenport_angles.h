#pragma once

#include <Eigen/Core>
#include <array>

namespace markerless_mocap {

/// Davenport's angles t, radians: R = exp(axes[0] t0) exp(axes[1] t1) exp(axes[2] t2); neighbouring
/// axes must be perpendicular unit vectors. Of the two solutions (and their full turns) the one
/// nearest to `near` is taken whose middle angle is inside its limits, if there is one; where only
/// a sum of the outer angles is defined, the first keeps its value.
Eigen::Vector3d davenportAngles(const Eigen::Matrix3d& R,
                                const std::array<Eigen::Vector3d, 3>& axes,
                                const Eigen::Vector3d& near, double middle_lower,
                                double middle_upper);

}  // namespace markerless_mocap
