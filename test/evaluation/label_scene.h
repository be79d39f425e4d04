#pragma once

#include <vector>

#include "evaluation/label_error.h"

namespace markerless_mocap {

enum { kHead, kLeftHand, kRightHand, kLeftFoot, kRightFoot };

/// Somebody who stands with the arms spread and looks along x: points and, beyond them, tips; then
/// wrists, elbows, ankles and knees.
inline JointTrack standing(int frames) {
  JointTrack truth;
  truth.names = labelTruthNames();
  Eigen::Matrix3Xd points(3, 18);
  points.transpose() << 0, 0, 1.6,  // head
      0, 0, 1.75,                   //
      0, 0.7, 1.4,                  // left hand
      0, 0.8, 1.4,                  //
      0, -0.7, 1.4,                 // right hand
      0, -0.8, 1.4,                 //
      0.1, 0.15, 0.05,              // left foot
      0.2, 0.15, 0.05,              //
      0.1, -0.15, 0.05,             // right foot
      0.2, -0.15, 0.05,             //
      0, 0.6, 1.4,                  // left wrist, elbow
      0, 0.4, 1.4,                  //
      0, -0.6, 1.4,                 // right wrist, elbow
      0, -0.4, 1.4,                 //
      0, 0.15, 0.08,                // left ankle, knee
      0, 0.12, 0.5,                 //
      0, -0.15, 0.08,               // right ankle, knee
      0, -0.12, 0.5;
  for (int f = 0; f < frames; ++f) truth.add(f, points);
  return truth;
}

/// Labels that are the truth.
inline std::vector<LabelledExtremities> trueLabels(const JointTrack& truth) {
  std::vector<LabelledExtremities> labels(truth.frames());
  for (size_t f = 0; f < labels.size(); ++f) {
    labels[f].valid = true;
    labels[f].validity = 1.0;
    for (int end = 0; end < kLabelledExtremityCount; ++end)
      labels[f].positions.col(end) = truth.positions[f].col(2 * end);
  }
  return labels;
}

inline void swapHands(LabelledExtremities* labels) {
  labels->positions.col(kLeftHand).swap(labels->positions.col(kRightHand));
}

inline void swapFeet(LabelledExtremities* labels) {
  labels->positions.col(kLeftFoot).swap(labels->positions.col(kRightFoot));
}

}  // namespace markerless_mocap
