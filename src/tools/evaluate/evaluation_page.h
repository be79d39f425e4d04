#pragma once

#include <string>

#include "tools/evaluate/evaluation.h"

namespace markerless_mocap {

/// One HTML page that needs nothing beside it: figures, status and error over time, error per
/// joint, histogram, overlaps, angles, pictures.
std::string evaluationPage(const Evaluation& evaluation);

}  // namespace markerless_mocap
