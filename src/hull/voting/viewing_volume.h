#pragma once

#include <Eigen/Geometry>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Number of cameras that must see a point of an automatic volume: three quarters of `cameras`.
int minViewsOf(int cameras);

/// Bounding box, in steps of 0.1 m, of the points up to 2.6 m above the floor that at least
/// `min_views` and minViewsOf() cameras see; empty if there are none. The search covers 8 m around
/// the cameras' centre.
Eigen::AlignedBox3d viewingVolume(const CameraRig& rig, int min_views, double floor_height);

}  // namespace markerless_mocap
