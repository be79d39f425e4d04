#include "evaluation/angle_error.h"

#include <cmath>

namespace markerless_mocap {

double angleBetween(double a, double b) {
  return std::abs(std::remainder(a - b, 2.0 * M_PI));
}

std::vector<AngleError> angleErrors(const std::vector<AngleFrame>& truth,
                                    const std::vector<AngleFrame>& estimate,
                                    const std::vector<int>& match) {
  std::map<std::string, std::vector<double>> differences;
  for (size_t f = 0; f < truth.size(); ++f) {
    if (match.at(f) < 0) continue;
    const AngleFrame& found = estimate.at(match[f]);
    for (const auto& joint : truth[f].angles) {
      const auto angle = found.angles.find(joint.first);
      if (angle == found.angles.end()) continue;
      differences[joint.first].push_back(angleBetween(joint.second, angle->second) * 180.0 / M_PI);
    }
  }
  std::vector<AngleError> errors;
  for (const auto& joint : differences)
    errors.push_back({joint.first, summaryStatistics(joint.second)});
  return errors;
}

}  // namespace markerless_mocap
