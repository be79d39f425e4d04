#pragma once

#include <string>

namespace markerless_mocap {

/// A figure by a printf format; "-" where there is none.
std::string figureText(const char* format, double value);

/// A share as "12.3 %".
std::string percentText(double share);

}  // namespace markerless_mocap
