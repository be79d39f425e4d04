#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "tools/import/film.h"

namespace markerless_mocap {

/// Such as "640 x 480".
std::string text(const cv::Size& size);

/// Makes a calibration and the film that it belongs to agree in size: the size is taken from the
/// film where the calibration has none, the film is not turned if the calibration is of the images
/// as they are stored, the calibration is scaled to a film of the same shape, and a film that lacks
/// up to a hundredth of the columns or rows is taken as cut at the right or bottom.
/// \param notes what was done
/// Throws std::invalid_argument if the sizes do not agree in any of these ways.
void agreeInSize(CameraCalibration* camera, Film* film, std::vector<std::string>* notes);

}  // namespace markerless_mocap
