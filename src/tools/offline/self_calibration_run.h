#pragma once

#include <string>
#include <vector>

#include "contour/self_calibration.h"
#include "tools/offline/offline_run.h"

namespace markerless_mocap {

/// Tracks the person through a recording and refines the camera orientations with the silhouettes.
/// The corrected rig is written to a file only if it is significantly better. Throws as
/// runOffline().
/// \param run recording, stages and body; at most the first minute is used
/// \param rig_file YAML, as written by writeRig(); an existing file is replaced
OrientationRefinement selfCalibrate(const OfflineOptions& run, const std::string& rig_file);

/// Lines of text: the result, the correction of each camera, and the file that was written.
std::vector<std::string> calibrationMessages(const OrientationRefinement& estimate,
                                             const std::string& rig_file);

}  // namespace markerless_mocap
