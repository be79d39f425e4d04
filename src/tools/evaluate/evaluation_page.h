#pragma once

#include <string>

#include "tools/evaluate/evaluation.h"

namespace markerless_mocap {

/// A self-contained HTML page: the player with the truth in grey, error over time and per joint,
/// histogram, overlaps, angles.
std::string evaluationPage(const Evaluation& evaluation);

}  // namespace markerless_mocap
