#pragma once

#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Throws std::invalid_argument, "<path> is <value>, allowed is <allowed>".
[[noreturn]] void throwNotAllowed(const std::string& path, const std::string& value,
                                  const std::string& allowed);

/// Throws as throwNotAllowed() if the field's value is out of range, not finite, or not one of the
/// texts that are allowed.
void checkOption(const std::string& path, const OptionField& field);

}  // namespace markerless_mocap
