#pragma once

#include <string>
#include <vector>

#include "evaluation/joint_track.h"

namespace markerless_mocap {

/// Statistics of what is finite; NaN when nothing is. Percentiles are linear between the samples.
struct SummaryStatistics {
  size_t count = 0;
  double mean, deviation, median, p95, max;
};
SummaryStatistics summaryStatistics(const std::vector<double>& values);

/// One marker's share of the error.
struct MarkerError {
  std::string name;
  size_t frames = 0;  ///< with both truth and estimate
  double mean_mm, max_mm;
  /// Mean of (estimate - truth) in the pelvis frame of the truth (x forward, y left, z up the
  /// spine), mm: what a different definition of the joint looks like.
  Eigen::Vector3d offset_mm;
  double mean_unbiased_mm;  ///< with that offset taken out
};

/// Share of frames with estimate in which exchanging left and right lowers D by more than 30 %.
struct SwapRates {
  double all, arms, legs;  ///< arms and legs: D over their own markers only; NaN without estimate
};

/// The error of an estimate over a sequence. D of a frame is the mean distance of its markers that
/// have an estimate (Fleischmann 2012, Eq. 4.4), in mm.
struct JointErrors {
  std::vector<double> D;           ///< per frame; NaN without estimate
  std::vector<double> D_unbiased;  ///< the same with each marker's offset taken out
  SummaryStatistics D_spread;
  double D_mean_unbiased, D_max_unbiased;  ///< NaN without estimate
  size_t frames = 0, frames_estimated = 0;
  double fraction_without_estimate;  ///< of the frames
  double fraction_markers_missing;   ///< of the markers in frames with estimate
  std::vector<MarkerError> markers;
  SwapRates swaps;
};

/// \param truth markers of the measure; pelvis, thorax, l_hip and r_hip are needed for what is
///   said in the pelvis frame (NaN without) \param estimate as alignedTo() gives it
/// Throws std::invalid_argument unless both have the same frames and names.
JointErrors jointErrors(const JointTrack& truth, const JointTrack& estimate);

/// Distances [marker][frame] in mm; NaN where one of the two is missing.
std::vector<std::vector<double>> markerDistances(const JointTrack& truth,
                                                 const JointTrack& estimate);

/// A hand or foot is right when it is at most this far away and nearer to its own side.
constexpr double kExtremityLimit_mm = 150.0;

/// Hands and feet as in Bakken and Hilton 2012, 4: error of knuckles and balls of the feet, and
/// the share of frames in which one is labelled right.
struct ExtremityError {
  std::string name;  ///< of the left and right points without their side: hand, foot
  SummaryStatistics error_mm;
  /// Of left and right in all frames of the truth; no estimate is not right.
  double fraction_correct;
};

/// \param truth, estimate tracks of the same frames that have l_<name> and r_<name>; NaN figures
///   where they have not
ExtremityError extremityError(const JointTrack& truth, const JointTrack& estimate,
                              const std::string& name);

}  // namespace markerless_mocap
