#pragma once

#include "evaluation/label_error.h"

namespace markerless_mocap {

/// Indices into extremityNames().
enum LabelledExtremity { kHead, kLeftHand, kRightHand, kLeftFoot, kRightFoot };

/// \param truth points of one frame, metres, columns by labelTruthNames()
LabelEvaluation evaluateLabels(const LabelledExtremities& labels, const Eigen::Matrix3Xd& truth);

}  // namespace markerless_mocap
