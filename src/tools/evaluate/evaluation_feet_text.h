#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "pages/page.h"
#include "tools/evaluate/evaluation_feet.h"

namespace markerless_mocap {

/// Feet on the floor and lost limbs as terminal output, JSON and parts of the page.
void printFeet(const FeetEvaluation& feet, std::ostream& out);
Json feetJson(const FeetEvaluation& feet);
void addFeet(const FeetEvaluation& feet, Page* page);

void printLimbs(const std::vector<LimbLoss>& limbs, std::ostream& out);
Json limbsJson(const std::vector<LimbLoss>& limbs);
void addLimbs(const std::vector<LimbLoss>& limbs, Page* page);

}  // namespace markerless_mocap
