#include "tools/common/number_format.h"

#include <cmath>
#include <cstdio>

#include "text/joined.h"

namespace markerless_mocap {

std::string formatNumber(const char* format, double value) {
  if (!std::isfinite(value)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  const std::string out = text;
  return out == "-0" ? "0" : out;
}

std::string formatPercent(double fraction) {
  return formatNumber("%.1f %%", 100.0 * fraction);
}

std::string formatCounts(const std::map<std::string, size_t>& counts) {
  return joined(counts,
                [](const auto& one) { return std::to_string(one.second) + ' ' + one.first; });
}

void printRow(std::ostream& out, const std::string& name, const std::string& text) {
  out << "  " << name << std::string(name.size() < 16 ? 16 - name.size() : 1, ' ') << text << '\n';
}

}  // namespace markerless_mocap
