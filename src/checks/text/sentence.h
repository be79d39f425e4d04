#pragma once

#include <string>

namespace markerless_mocap {

/// std::printf into a string.
[[gnu::format(printf, 1, 2)]] std::string sentence(const char* format, ...);

}  // namespace markerless_mocap
