#pragma once

#include <string>

#include "markerless_mocap/tracking/shape_parameters.h"

namespace markerless_mocap {

/// Height of the person who stands upright, metres: the sum of the lengths from floor to crown.
double statureOf(const ShapeParameters& sizes);

/// A person's sizes as YAML: one line each, metres.
std::string shapeToYaml(const ShapeParameters& sizes);

/// What shapeToYaml() wrote. Throws std::invalid_argument in one sentence that names `where` and
/// the size: no YAML map, a size missing or unknown, no finite number, or a length or radius that
/// is not positive.
ShapeParameters shapeFromYaml(const std::string& yaml, const std::string& where);

}  // namespace markerless_mocap
