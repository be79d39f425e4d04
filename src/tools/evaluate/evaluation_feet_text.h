#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tools/evaluate/evaluation_feet.h"
#include "tools/evaluate/json_text.h"

namespace markerless_mocap {

/// Feet on the floor and lost limbs as terminal output, JSON and HTML.
void printFeet(const FeetEvaluation& feet, std::ostream& out);
JsonObject feetObject(const FeetEvaluation& feet);
/// \param seconds of each frame
std::string feetSection(const FeetEvaluation& feet, const std::vector<double>& seconds);

void printLimbs(const std::vector<LimbLoss>& limbs, std::ostream& out);
JsonObject limbsObject(const std::vector<LimbLoss>& limbs);
std::string limbsSection(const std::vector<LimbLoss>& limbs, const std::vector<double>& seconds);

}  // namespace markerless_mocap
