#pragma once

#include "evaluation/joint_error.h"
#include "evaluation/part_truth.h"

namespace markerless_mocap {

/// What a segmentation says about one frame. Parts are numbered torso, head, arm, arm, leg, leg;
/// which arm and which leg is the left one is left open.
struct SegmentedHull {
  bool valid = false;                                   ///< whether it stands by all six parts
  double pitch = 0.0;                                   ///< metres from a voxel to the next
  Eigen::Matrix3Xd voxels;                              ///< centres on a lattice, metres
  std::vector<uint8_t> labels;                          ///< part of each voxel
  std::array<Eigen::Matrix3Xd, kTruePartCount> curves;  ///< metres; without columns if not seen
};

/// One frame judged. Shares are of its voxels.
struct PartEvaluation {
  bool judged = false;  ///< there are voxels and the truth has all points
  bool valid = false;
  /// Whether no forearm, hand, shank or foot touches another part in the hull: by the truth no
  /// voxel of it has a face in common with one of another part.
  bool free = false;
  double fraction_correct = 0.0;
  double fraction_correct_inside = 0.0;  ///< of the voxels farther than 60 mm from a true border;
                                         ///< NaN without any
  std::array<double, kTruePartCount> overlap{};  ///< intersection over union, by truePartNames()
  bool all_six_correct = false;                  ///< all overlaps are over a half
  /// Mean distance from the curve's points to the true axis, mm, by truePartNames(); NaN if not
  /// seen.
  std::array<double, kTruePartCount> curve_mm{};
};

/// Over the frames of one kind.
struct PartStatistics {
  size_t frames = 0;
  double fraction_correct, worst_correct, fraction_correct_inside,
      fraction_all_six;  ///< NaN without frames
};

struct PartErrors {
  std::vector<PartEvaluation> verdicts;  ///< per frame of the truth
  PartStatistics all, free, touching, valid;
  double fraction_valid;  ///< of the judged frames
  SummaryStatistics torso_mm, head_mm, arms_mm,
      legs_mm;  ///< curves of the parts with an overlap over a half
};

PartEvaluation evaluateParts(const Eigen::Matrix3Xd& true_points, const SegmentedHull& segmented);

/// \param truth track with partTruthNames() \param hulls one for each of its frames; throws
///   std::invalid_argument otherwise, or if a hull's labels are not as many as its voxels or name
///   no part
PartErrors partErrors(const JointTrack& truth, const std::vector<SegmentedHull>& hulls);

}  // namespace markerless_mocap
