#pragma once

#include <string>
#include <vector>

namespace markerless_mocap {

/// Trust in each camera, 0 to 1; 1 where no entry names it.
/// \param entries as HullOptions::camera_trust
/// Throws std::invalid_argument on an entry that is not <camera>=<number> with one of the cameras
/// and a number of 0 to 1.
std::vector<double> trustIn(const std::vector<std::string>& cameras,
                            const std::vector<std::string>& entries);

}  // namespace markerless_mocap
