#pragma once

#include <map>
#include <ostream>
#include <string>

namespace markerless_mocap {

/// A number in a printf format; "-" if it is not finite.
std::string formatNumber(const char* format, double value);

/// A fraction as "12.3 %".
std::string formatPercent(double fraction);

/// How often each word occurs, as "12 ok, 3 lost".
std::string formatCounts(const std::map<std::string, size_t>& counts);

/// One row of a table on the terminal.
void printRow(std::ostream& out, const std::string& name, const std::string& text);

}  // namespace markerless_mocap
