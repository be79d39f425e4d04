#pragma once

#include <array>

#include "skeleton/labelling/label_curve.h"
#include "skeleton/labelling/label_doubts.h"

namespace markerless_mocap {

/// Parts of the log-odds that a labelled tree is right, by LabelDoubt.
extern const double kDoubtConstant;
extern const std::array<LabelCurve, kLabelDoubtCount> kDoubtCurves;

}  // namespace markerless_mocap
