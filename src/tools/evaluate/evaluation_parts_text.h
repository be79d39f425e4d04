#pragma once

#include <ostream>

#include "pages/page.h"
#include "tools/evaluate/evaluation_parts.h"

namespace markerless_mocap {

/// Prints the rows of the segmentation.
void printParts(const PartsEvaluation& parts, std::ostream& out);

/// Fractions 0 to 1, distances in mm; null if there is no value.
Json partsJson(const PartsEvaluation& parts);

/// Section of the report: numbers, correctness over time, curves.
void addParts(const PartsEvaluation& parts, Page* page);

}  // namespace markerless_mocap
