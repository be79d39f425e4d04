#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "tools/evaluate/evaluation_tree.h"
#include "tools/evaluate/json_text.h"

namespace markerless_mocap {

/// The tree's lines of the terminal's table.
void printTrees(const TreeEvaluation& trees, std::ostream& out);

/// Shares 0..1, errors in mm, the curve as [threshold, precision, recall]; null where there is
/// none.
JsonObject treesObject(const TreeEvaluation& trees);

/// A section of the report: figures, what was right when, errors, precision and recall over the
/// threshold. \param seconds of the truth's frames
std::string treesSection(const TreeEvaluation& trees, const std::vector<double>& seconds);

}  // namespace markerless_mocap
