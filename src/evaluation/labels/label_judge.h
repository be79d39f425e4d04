#pragma once

#include "evaluation/label_error.h"

namespace markerless_mocap {

/// Places among endNames().
enum EndIndex { kHead, kLeftHand, kRightHand, kLeftFoot, kRightFoot };

/// \param truth of one frame, its columns by labelTruthNames()
LabelVerdict judgeLabels(const LabelledEnds& labels, const Eigen::Matrix3Xd& truth);

}  // namespace markerless_mocap
