#pragma once

#include "checks/finding.h"
#include "checks/motion/explanation.h"

namespace markerless_mocap {

Finding findingOf(const Explanation& explanation, const std::vector<std::string>& names);

}  // namespace markerless_mocap
