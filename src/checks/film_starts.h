#pragma once

#include <vector>

#include "camera/film_clocks.h"
#include "checks/seen_rig.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// A person in the film of one camera.
struct FilmedPerson {
  CameraCalibration calibration;  ///< of the world, metres, z up; its time_offset is not used
  std::vector<double> seconds;    ///< of each image, clock of the film, ascending
  std::vector<Outline> outlines;  ///< of each image
};

/// When films of a person began, by where calibrated cameras see that person: to a part of the time
/// between images. \param largest offset that is searched for, s
FilmClocks personClocks(const std::vector<FilmedPerson>& films,
                        double largest = kLargestFilmOffset);

}  // namespace markerless_mocap
