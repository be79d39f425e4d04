#pragma once

#include <string>

#include "tools/evaluate/evaluation.h"

namespace markerless_mocap {

/// All results as one JSON object: mm, s, degrees, fractions 0 to 1; null if there is no value.
std::string evaluationJson(const Evaluation& evaluation);

}  // namespace markerless_mocap
