#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Pose of an optical frame (x right, y down, z forward) at `position` that looks at `target`, with
/// the world's z up in the image (x up if it looks straight down or up). Throws
/// std::invalid_argument if both points are equal.
Eigen::Isometry3d lookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target);

/// A rig of cameras around the world's origin, named cam0, cam1, ...
struct RigPlan {
  std::string kind = "ring7_overhead";  ///< one of rigKinds()
  int width = 640, height = 480;        ///< pixels
  double distortion_k1 = 0.0;           ///< first radial coefficient of all lenses
  uint64_t seed = 1;                    ///< of the random rig
};

/// ring8, ring7_overhead, ring4, ring16 (height 1.9 m, 4.2 m from the centre; the overhead camera
/// at 4.6 m), ceiling4 (in the upper corners of a square of 5.2 m), random8 (random positions and
/// lenses near those of ring8), wide6 (fisheye lenses of 105 x 78 degrees, 2.2 m from the centre
/// at 2.3 m height).
const std::vector<std::string>& rigKinds();

/// Creates a rig. The field of view of each lens just covers volumePoints() for any image shape.
/// Rotations are rounded as in a rig file, so that writing and reading the rig does not change it.
/// Throws std::invalid_argument if the kind is unknown.
CameraRig makeRig(const RigPlan& plan);

/// Outline of the capture volume, metres: a cylinder of 1.3 m radius about the z axis, 0 to 2.4 m
/// high.
std::vector<Eigen::Vector3d> volumePoints();

}  // namespace markerless_mocap
