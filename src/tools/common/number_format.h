#pragma once

#include <ostream>
#include <string>

namespace markerless_mocap {

/// A number in a printf format; "-" if it is not finite.
std::string formatNumber(const char* format, double value);

/// A fraction as "12.3 %".
std::string formatPercent(double fraction);

/// One row of a table on the terminal.
void printRow(std::ostream& out, const std::string& name, const std::string& text);

}  // namespace markerless_mocap
