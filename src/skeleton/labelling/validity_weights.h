#pragma once

#include <array>

#include "skeleton/labelling/piecewise_linear.h"
#include "skeleton/labelling/validity_features.h"

namespace markerless_mocap {

/// Parts of the log-odds that a labelled tree is right, by ValidityFeature.
extern const double kValidityIntercept;
extern const std::array<PiecewiseLinear, kValidityFeatureCount> kValidityCurves;

}  // namespace markerless_mocap
