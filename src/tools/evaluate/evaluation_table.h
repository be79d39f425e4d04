#pragma once

#include <ostream>

#include "tools/evaluate/evaluation.h"

namespace markerless_mocap {

/// A table for a terminal of 80 columns that can be read at a glance.
void printEvaluation(const Evaluation& evaluation, std::ostream& out);

/// One row per camera and one for all; NaN where nothing was compared.
double meanOfMeans(const std::vector<SummaryStatistics>& spreads);

}  // namespace markerless_mocap
