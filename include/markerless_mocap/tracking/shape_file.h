#pragma once

#include <string>

#include "markerless_mocap/tracking/shape_parameters.h"

namespace markerless_mocap {

/// Height of the upright person, metres: the sum of the lengths from floor to crown.
double statureOf(const ShapeParameters& shape);

/// The shape of a person as YAML: one line per parameter, metres.
std::string shapeToYaml(const ShapeParameters& shape);

/// Reads what shapeToYaml() wrote. Throws std::invalid_argument if the text is no YAML map, if a
/// parameter is missing, unknown or no finite number, or if a length or radius is not positive. The
/// message names `where` and the parameter.
ShapeParameters shapeFromYaml(const std::string& yaml, const std::string& where);

}  // namespace markerless_mocap
