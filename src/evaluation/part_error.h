#pragma once

#include "evaluation/joint_error.h"
#include "evaluation/part_truth.h"

namespace markerless_mocap {

/// Segmentation of one frame. Parts are numbered torso, head, arm, arm, leg, leg; left and right
/// are not distinguished.
struct SegmentedHull {
  bool valid = false;           ///< whether all six parts are reported as valid
  double pitch = 0.0;           ///< distance between neighbouring voxels, metres
  Eigen::Matrix3Xd voxels;      ///< centres of voxels on a lattice, metres
  std::vector<uint8_t> labels;  ///< part of each voxel
  std::array<Eigen::Matrix3Xd, kTruePartCount>
      curves;  ///< points of the curves, metres; no columns if not seen
};

/// Evaluation of one frame. Fractions are of its voxels.
struct PartEvaluation {
  bool evaluated = false;  ///< whether there are voxels and the truth has all points
  bool valid = false;
  /// Whether no forearm, hand, shank or foot touches another part in the hull: none of its true
  /// voxels shares a face with a voxel of another true part.
  bool free = false;
  double fraction_correct = 0.0;
  double fraction_correct_inside =
      0.0;  ///< of the voxels further than 60 mm from a true border; NaN without any
  std::array<double, kTruePartCount> overlap{};  ///< intersection over union, by TruePart::Id
  bool all_six_correct = false;                  ///< all overlaps exceed 0.5
  /// Mean distance of the curve's points from the true axis, mm, by TruePart::Id; NaN if not
  /// seen.
  std::array<double, kTruePartCount> curve_mm{};
};

/// Statistics over the frames of one group.
struct PartStatistics {
  size_t frames = 0;
  double fraction_correct, worst_correct, fraction_correct_inside,
      fraction_all_six;  ///< NaN without frames
};

struct PartErrors {
  std::vector<PartEvaluation> verdicts;  ///< per frame of the truth
  PartStatistics all, free, touching, valid;
  double fraction_valid;  ///< fraction of the evaluated frames
  SummaryStatistics torso_mm, head_mm, arms_mm,
      legs_mm;  ///< curves of the parts with an overlap over a half
};

PartEvaluation evaluateParts(const Eigen::Matrix3Xd& true_points, const SegmentedHull& segmented);

/// \param truth track with partTruthNames()
/// \param hulls one for each of its frames; throws std::invalid_argument otherwise, or if a hull
///   does not have one valid label per voxel
PartErrors partErrors(const JointTrack& truth, const std::vector<SegmentedHull>& hulls);

}  // namespace markerless_mocap
