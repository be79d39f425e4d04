#pragma once

#include <array>

#include "contour/model/contour_pose.h"

namespace markerless_mocap {

/// Range of an angle, radians.
struct AngleRange {
  double lower, upper;
};

/// Limits of the revolute joints: those of urdf/human.urdf.in if it has the joint. The fit may
/// exceed them slightly.
constexpr std::array<AngleRange, RevoluteJoint::kCount> kAngleRanges = {{
    {-0.6, 1.4},  // spine
    {-0.7, 0.7},
    {-0.8, 0.8},
    {-0.4, 0.5},  // clavicles
    {-0.3, 0.7},
    {-0.4, 0.5},
    {-0.3, 0.7},
    {0.0, 2.7},  // elbows
    {0.0, 2.7},
    {-2.7, 0.0},  // knees
    {-2.7, 0.0},
    {-0.9, 0.6},  // ankles
    {-0.9, 0.6},
}};

}  // namespace markerless_mocap
