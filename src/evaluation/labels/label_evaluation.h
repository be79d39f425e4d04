#pragma once

#include "evaluation/label_error.h"

namespace markerless_mocap {

/// Places among extremityNames().
enum LabelledExtremity { kHead, kLeftHand, kRightHand, kLeftFoot, kRightFoot };

/// \param truth of one frame, its columns by labelTruthNames()
LabelEvaluation evaluateLabels(const LabelledExtremities& labels, const Eigen::Matrix3Xd& truth);

}  // namespace markerless_mocap
