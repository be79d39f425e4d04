#pragma once

#include <string>

#include "markerless_mocap/tracking/contour_sizes.h"

namespace markerless_mocap {

/// Height of the person who stands upright, metres: the sum of the lengths from floor to crown.
double statureOf(const ContourSizes& sizes);

/// A person's sizes as YAML: one line each, metres.
std::string sizesText(const ContourSizes& sizes);

/// What sizesText() wrote. Throws std::invalid_argument in one sentence that names `where` and the
/// size: no YAML map, a size missing or unknown, no finite number, or a length or radius that is
/// not positive.
ContourSizes sizesFromText(const std::string& yaml, const std::string& where);

}  // namespace markerless_mocap
