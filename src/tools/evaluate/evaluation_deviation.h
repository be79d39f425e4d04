#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "evaluation/uncertainty_calibration.h"
#include "tools/evaluate/evaluation_results.h"
#include "tools/evaluate/json_text.h"

namespace markerless_mocap {

/// Expected errors of the parts' ends against those made; empty when none are told.
/// \param match index into the results' frames for each frame of the truth, or -1
std::vector<UncertaintyCalibration> evaluateDeviations(const JointTrack& truth,
                                                       const ResultRecord& results,
                                                       const std::vector<int>& match);

void printDeviations(const std::vector<UncertaintyCalibration>& deviations, std::ostream& out);
JsonObject deviationsObject(const std::vector<UncertaintyCalibration>& deviations);
/// A section of the page; empty without any.
std::string deviationsSection(const std::vector<UncertaintyCalibration>& deviations);

}  // namespace markerless_mocap
