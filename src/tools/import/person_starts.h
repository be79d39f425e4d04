#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/import/film.h"
#include "tools/import/import_recording.h"

namespace markerless_mocap {

/// When films began, by the silhouettes of the person in them.
/// \param cameras of the films, metres, z up
/// \param offsets s, to be added to the times of each film; changed if they are clear, or if the
///   films are said to have begun apart
/// \param progress called with the part that is done, 0 to 1
/// \return sentences for people: what was found, and what is not certain
std::vector<std::string> findPersonStarts(const std::vector<Film>& films,
                                          const std::vector<CameraCalibration>& cameras,
                                          const FilmsInput& input, std::vector<double>* offsets,
                                          const std::function<void(double)>& progress);

}  // namespace markerless_mocap
