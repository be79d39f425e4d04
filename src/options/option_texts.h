#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// The field's value as YAML; numbers in the shortest form that reads back as the same number.
std::string valueText(const OptionField& field);

/// The range of a number, such as "0.005 to 0.2".
std::string rangeText(const OptionField& field);

/// What may stand in YAML, such as "three numbers, each -10 to 10".
std::string allowedText(const OptionField& field);

/// The text for a message: of a long one (UTF-8) the beginning, and " ...".
std::string shortened(const std::string& text);

}  // namespace markerless_mocap
