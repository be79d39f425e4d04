#pragma once

#include <string>

#include "tools/evaluate/evaluation.h"

namespace markerless_mocap {

/// A self-contained HTML page: numbers, status and error over time, error per joint, histogram,
/// overlaps, angles, images.
std::string evaluationPage(const Evaluation& evaluation);

}  // namespace markerless_mocap
