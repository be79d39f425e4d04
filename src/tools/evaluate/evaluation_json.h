#pragma once

#include <string>

#include "tools/evaluate/evaluation.h"

namespace markerless_mocap {

/// All figures as one JSON object: mm, s, degrees, shares 0..1; null where there is none.
std::string evaluationJson(const Evaluation& evaluation);

}  // namespace markerless_mocap
