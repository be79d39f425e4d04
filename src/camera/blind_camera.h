#pragma once

#include <string>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Takes the place in a rig of a camera of which nothing is known: it stands far below all others
/// and looks down. Its images are not to be used.
Camera blindCamera(const std::string& name);
bool isBlind(const Camera& camera);

}  // namespace markerless_mocap
