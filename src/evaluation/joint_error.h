#pragma once

#include <string>
#include <vector>

#include "evaluation/joint_track.h"

namespace markerless_mocap {

/// Statistics of the finite values; NaN if there are none. Percentiles are interpolated linearly
/// between samples.
struct SummaryStatistics {
  size_t count = 0;
  double mean, deviation, median, p95, max;
};
SummaryStatistics summaryStatistics(const std::vector<double>& values);

/// Error of one marker.
struct MarkerError {
  std::string name;
  size_t frames = 0;  ///< frames with both truth and estimate
  double mean_mm, max_mm;
  /// Mean of (estimate - truth) in the pelvis frame of the truth (x forward, y left, z up the
  /// spine), mm. A different definition of the joint causes such an offset.
  Eigen::Vector3d offset_mm;
  double mean_unbiased_mm;  ///< after that offset is removed
};

/// Fraction of frames with an estimate in which exchanging left and right lowers D by more than 30
/// %.
struct SwapRates {
  double all, arms,
      legs;  ///< for arms and legs D is over their own markers only; NaN without estimate
};

/// Errors of an estimate over a sequence. D of a frame is the mean distance over its markers that
/// have an estimate (Fleischmann 2012, Eq. 4.4), mm.
struct JointErrors {
  std::vector<double> D;           ///< per frame; NaN without estimate
  std::vector<double> D_unbiased;  ///< the same after removal of each marker's offset
  SummaryStatistics D_spread;
  double D_mean_unbiased, D_max_unbiased;  ///< NaN without estimate
  size_t frames = 0, frames_estimated = 0;
  double fraction_without_estimate;  ///< of the frames
  double fraction_markers_missing;   ///< of the markers in frames with estimate
  std::vector<MarkerError> markers;
  SwapRates swaps;
};

/// \param truth markers of the measure; pelvis, thorax, l_hip and r_hip are needed for the fields
///   in the pelvis frame (NaN without)
/// \param estimate as returned by alignedTo()
/// Throws std::invalid_argument unless both have the same frames and names.
JointErrors jointErrors(const JointTrack& truth, const JointTrack& estimate);

/// Distances [marker][frame], mm; NaN if truth or estimate is missing.
std::vector<std::vector<double>> markerDistances(const JointTrack& truth,
                                                 const JointTrack& estimate);

/// A hand or foot is correct if its error is at most this, and it is nearer to the true point of
/// its own side.
constexpr double kExtremityLimit_mm = 150.0;

/// Hands and feet as in Bakken & Hilton 2012, section 4: error of knuckles and balls of the feet,
/// and the fraction of frames in which they are labelled correctly.
struct ExtremityError {
  std::string name;  ///< name of the points without their side: hand, foot
  SummaryStatistics error_mm;
  /// Over left and right in all frames of the truth; a missing estimate is not correct.
  double fraction_correct;
};

/// \param truth, estimate tracks of the same frames that have l_<name> and r_<name>; values are NaN
///   if they do not
ExtremityError extremityError(const JointTrack& truth, const JointTrack& estimate,
                              const std::string& name);

}  // namespace markerless_mocap
