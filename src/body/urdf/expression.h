#pragma once

#include <map>
#include <string>

namespace markerless_mocap {

/// Value of an expression of + - * / ( ), decimal numbers and names. Throws std::invalid_argument
/// on an unknown name, which is in the message, on a syntax error, or if the value is not finite.
double evaluate(const std::string& expression, const std::map<std::string, double>& names);

}  // namespace markerless_mocap
