#pragma once

#include <Eigen/Core>
#include <string>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/capture/studio_options.h"

namespace markerless_mocap {

/// Pose of an optical frame (x right, y down, z forward) at `position` that looks at `target` with
/// the world's z up in the image (x up when looking straight down or up). Throws
/// std::invalid_argument if the two points are one.
Eigen::Isometry3d lookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target);

/// Where all cameras of the ring look, metres.
Eigen::Vector3d ringTarget();

/// Cameras cam0, cam1, ... at equal angles on a circle about the world's z axis, cam0 at +x,
/// looking at ringTarget(); with `overhead` the last camera hangs above the centre instead.
CameraRig cameraRing(const StudioOptions& options);

}  // namespace markerless_mocap
