#pragma once

#include <Eigen/Geometry>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// How many of some cameras must see a place of an automatic volume: three quarters.
int enoughViews(int cameras);

/// The least box, in steps of 0.1 m, around all places above the floor, and less than 2.6 m above,
/// that at least `min_views` and enough cameras see; empty if there are none.
/// Searched within 8 m of the cameras' middle.
Eigen::AlignedBox3d seenVolume(const CameraRig& rig, int min_views, double floor_height);

}  // namespace markerless_mocap
