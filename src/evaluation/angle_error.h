#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"

namespace markerless_mocap {

/// Joint angles of one body at one time, radians, by joint name without the body's id.
struct AngleFrame {
  int64_t stamp_ns = 0;
  std::map<std::string, double> angles;
};

struct AngleError {
  std::string joint;
  SummaryStatistics error_deg;  ///< of the absolute difference, up to 180
};

/// Absolute difference of two angles on the circle, radians, 0 to pi.
double angleBetween(double a, double b);

/// Errors per joint of the truth, sorted by name, over the matched frames. Joints that the estimate
/// never has are left out.
/// \param match index into `estimate` for each frame of the truth, or -1; see matchStamps()
std::vector<AngleError> angleErrors(const std::vector<AngleFrame>& truth,
                                    const std::vector<AngleFrame>& estimate,
                                    const std::vector<int>& match);

}  // namespace markerless_mocap
