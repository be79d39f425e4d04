#pragma once

#include <ostream>
#include <string>

namespace markerless_mocap {

/// A figure by a printf format; "-" where there is none.
std::string formatNumber(const char* format, double value);

/// A share as "12.3 %".
std::string formatPercent(double fraction);

/// A line of a terminal's table: a name and what it says.
void printRow(std::ostream& out, const std::string& name, const std::string& text);

}  // namespace markerless_mocap
