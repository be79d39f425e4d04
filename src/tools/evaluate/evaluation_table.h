#pragma once

#include <ostream>

#include "tools/evaluate/evaluation.h"

namespace markerless_mocap {

/// Prints a summary for a terminal of 80 columns.
void printEvaluation(const Evaluation& evaluation, std::ostream& out);

/// Mean over cameras of their mean values; NaN without any.
double meanOfMeans(const std::vector<SummaryStatistics>& spreads);

}  // namespace markerless_mocap
