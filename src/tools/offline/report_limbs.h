#pragma once

#include <string>
#include <vector>

#include "tools/offline/report_page.h"

namespace markerless_mocap {

/// When and why parts of the body were not seen, as HTML: a band over time for each part, a table
/// of frames and expected errors, and the reasons that were given, counted. \param seconds of each
/// row, ascending
std::string limbSection(const std::vector<ReportRow>& rows, const std::vector<double>& seconds);

}  // namespace markerless_mocap
