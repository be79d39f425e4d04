#pragma once

#include <Eigen/Core>
#include <string>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/capture/rigs.h"
#include "markerless_mocap/capture/studio_options.h"

namespace markerless_mocap {

/// Where all cameras of the ring look, metres.
Eigen::Vector3d ringTarget();

/// Cameras cam0, cam1, ... at equal angles on a circle about the world's z axis, cam0 at +x,
/// looking at ringTarget(); with `overhead` the last camera hangs above the centre instead.
CameraRig cameraRing(const StudioOptions& options);

}  // namespace markerless_mocap
