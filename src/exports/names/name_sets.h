#pragma once

#include <string>
#include <vector>

#include "exports/point_names.h"

namespace markerless_mocap {

struct NameSet {
  std::string name;
  std::vector<NamedPoint> points;
};

const std::vector<NameSet>& allNameSets();

}  // namespace markerless_mocap
