#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tools/evaluate/evaluation_parts.h"
#include "tools/evaluate/json_text.h"

namespace markerless_mocap {

/// The segmentation's lines of the terminal's table.
void printParts(const PartsEvaluation& parts, std::ostream& out);

/// Shares 0..1, distances in mm; null where there is none.
JsonObject partsObject(const PartsEvaluation& parts);

/// A section of the report: figures, what was right when, curves. \param seconds of the truth's
/// frames
std::string partsSection(const PartsEvaluation& parts, const std::vector<double>& seconds);

}  // namespace markerless_mocap
