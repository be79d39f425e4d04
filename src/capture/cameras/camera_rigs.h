#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Pose of an optical frame (x right, y down, z forward) at `position` that looks at `target` with
/// the world's z up in the image (x up when looking straight down or up). Throws
/// std::invalid_argument if the two points are one.
Eigen::Isometry3d lookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target);

/// Cameras about the world's origin, named cam0, cam1, ...
struct RigPlan {
  std::string kind = "ring7_overhead";  ///< one of rigKinds()
  int width = 640, height = 480;        ///< pixels
  double distortion_k1 = 0.0;           ///< first radial coefficient of every lens
  uint64_t seed = 1;                    ///< of the random rig
};

/// ring8, ring7_overhead, ring4 (all at 1.9 m, 4.2 m from the centre; the overhead camera at 4.6
/// m), ceiling4 (in the upper corners of a square of 5.2 m), random8 (each with a place and a lens
/// of its own about those of ring8).
const std::vector<std::string>& rigKinds();

/// A lens is as wide as it takes to see volumePoints(), whatever the image's shape. Rotations are
/// as a rig file keeps them, so writing and reading the rig changes nothing. Throws
/// std::invalid_argument if the kind is unknown.
CameraRig makeRig(const RigPlan& plan);

/// Outline of where people act: a cylinder of 1.3 m radius about the z axis, 0 to 2.4 m high.
std::vector<Eigen::Vector3d> volumePoints();

}  // namespace markerless_mocap
