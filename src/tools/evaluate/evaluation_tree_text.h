#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "tools/evaluate/evaluation_tree.h"
#include "tools/evaluate/json_text.h"

namespace markerless_mocap {

/// Prints the rows of the pose tree.
void printTrees(const TreeEvaluation& trees, std::ostream& out);

/// Fractions 0 to 1, errors in mm, the curve as [threshold, precision, recall]; null if there is no
/// value.
JsonObject treesObject(const TreeEvaluation& trees);

/// Section of the report: numbers, correctness over time, errors, precision and recall over the
/// threshold. \param seconds of the frames of the ground truth
std::string treesSection(const TreeEvaluation& trees, const std::vector<double>& seconds);

}  // namespace markerless_mocap
