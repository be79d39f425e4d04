#pragma once

#include <string>
#include <vector>

#include "tools/offline/report_page.h"

namespace markerless_mocap {

/// What each camera contributed, as HTML: its background, the share of its masks that is unknown
/// and their overlap with the body over time, and its views. \param seconds of each row, ascending
std::string cameraSections(const ReportContent& content, const std::vector<double>& seconds);

/// Mean over the frames with a figure; NaN without any.
double meanOfFinite(const std::vector<double>& values);

}  // namespace markerless_mocap
