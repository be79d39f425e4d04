#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tools/evaluate/evaluation_parts.h"
#include "tools/evaluate/json_text.h"

namespace markerless_mocap {

/// Prints the rows of the segmentation.
void printParts(const PartsEvaluation& parts, std::ostream& out);

/// Fractions 0 to 1, distances in mm; null if there is no value.
JsonObject partsObject(const PartsEvaluation& parts);

/// Section of the report: numbers, correctness over time, curves. \param seconds of the frames of
/// the ground truth
std::string partsSection(const PartsEvaluation& parts, const std::vector<double>& seconds);

}  // namespace markerless_mocap
