#pragma once

#include <array>
#include <string>

#include "files/yaml_map.h"
#include "skeleton/labelling/piecewise_linear.h"

namespace markerless_mocap {

/// A curve of a model file. Throws std::invalid_argument as YamlMap does.
PiecewiseLinear curveIn(YamlMap map);

/// One curve for each feature, under the key toString(Feature). The map must have no other keys.
template <class Feature, size_t kCount>
std::array<PiecewiseLinear, kCount> curvesIn(YamlMap map) {
  std::array<PiecewiseLinear, kCount> out;
  for (size_t i = 0; i < kCount; ++i) out[i] = curveIn(map.map(toString(Feature(i))));
  map.finish();
  return out;
}

}  // namespace markerless_mocap
