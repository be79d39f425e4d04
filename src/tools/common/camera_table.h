#pragma once

#include <ostream>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// One line per camera: name, size in pixels, position in metres and viewing direction.
void printCameras(const std::vector<CameraCalibration>& cameras, std::ostream& out);

}  // namespace markerless_mocap
