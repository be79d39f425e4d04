#pragma once

#include <ostream>

#include "pages/page.h"
#include "tools/evaluate/evaluation_tree.h"

namespace markerless_mocap {

/// Prints the rows of the pose tree.
void printTrees(const TreeEvaluation& trees, std::ostream& out);

/// Fractions 0 to 1, errors in mm, the curve as [threshold, precision, recall]; null if there is no
/// value.
Json treesJson(const TreeEvaluation& trees);

/// Section of the report: numbers, correctness over time, errors, precision and recall over the
/// threshold.
void addTrees(const TreeEvaluation& trees, Page* page);

}  // namespace markerless_mocap
