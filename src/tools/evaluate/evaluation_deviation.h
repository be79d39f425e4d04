#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "evaluation/uncertainty_calibration.h"
#include "pages/page.h"
#include "tools/common/result_record.h"

namespace markerless_mocap {

/// Compares the estimated errors of the parts' ends with the actual ones; empty if none are
/// estimated.
/// \param match index of the result for each frame of the ground truth, or -1
std::vector<UncertaintyCalibration> evaluateDeviations(const JointTrack& truth,
                                                       const ResultRecord& results,
                                                       const std::vector<int>& match);

void printDeviations(const std::vector<UncertaintyCalibration>& deviations, std::ostream& out);
Json deviationsJson(const std::vector<UncertaintyCalibration>& deviations);
/// Section of the report; nothing without data.
void addDeviations(const std::vector<UncertaintyCalibration>& deviations, Page* page);

}  // namespace markerless_mocap
