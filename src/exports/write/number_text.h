#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace markerless_mocap {

/// With a point whatever the locale of the program says.
inline std::string numberText(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  for (char* c = text; *c; ++c)
    if (*c == ',') *c = '.';
  return text;
}

/// Empty if the value is not finite.
inline std::string numberOrNothing(double value, int decimals) {
  return std::isfinite(value) ? numberText(value, decimals) : "";
}

}  // namespace markerless_mocap
