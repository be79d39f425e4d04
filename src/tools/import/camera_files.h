#pragma once

#include <map>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Files of each numbered camera, sorted by name. `%d` or `%0Nd` in the pattern stands for the
/// number of the camera (0 to 999); `*`, `?` and `[...]` match as in a shell. Throws
/// std::runtime_error if the pattern has no number or matches no file.
std::map<int, std::vector<std::string>> filesByCamera(const std::string& pattern);

}  // namespace markerless_mocap
