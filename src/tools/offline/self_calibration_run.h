#pragma once

#include <string>
#include <vector>

#include "contour/self_calibration.h"
#include "tools/offline/offline_run.h"

namespace markerless_mocap {

/// Follows the person through a recording and estimates from it how the cameras point. If that is
/// surely better than the calibration as given, the corrected rig is written to a file; else no
/// file is. Throws as runOffline().
/// \param run the recording, its stages and body; of a long one the first minute is used
/// \param rig_file YAML, as writeRig() makes it; replaced if it exists
OrientationRefinement selfCalibrate(const OfflineOptions& run, const std::string& rig_file);

/// What was found and done, and where the rig is if it was written; a sentence each.
std::vector<std::string> calibrationMessages(const OrientationRefinement& estimate,
                                             const std::string& rig_file);

}  // namespace markerless_mocap
