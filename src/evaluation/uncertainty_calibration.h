#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Frames with similar expected error. If the expected error is calibrated, both values are equal.
struct UncertaintyBin {
  size_t frames;
  double expected_mm, actual_mm;  ///< root mean squares
};

/// Comparison of the errors that a tracker expects of a point with its actual errors.
struct UncertaintyCalibration {
  std::string point;
  size_t frames = 0;              ///< frames with both
  double expected_mm, actual_mm;  ///< root mean squares; NaN without frames
  /// Fraction of the frames whose error is at most twice the expected one.
  double fraction_within_two_sigma;
  /// Of error / expected error: 95 % of the frames are below. At most 2 if the errors are covered.
  double normalised_95;
  std::vector<UncertaintyBin> bins;  ///< quintiles of the frames by expected error, ascending
};

/// \param expected_m standard deviation of the point as reported, metres, per frame; NaN: not
///   reported
/// \param error_mm distance from the true point, mm, per frame; NaN without estimate
/// Throws std::invalid_argument unless both have the same number of frames.
UncertaintyCalibration uncertaintyCalibration(const std::string& point,
                                              const std::vector<double>& expected_m,
                                              const std::vector<double>& error_mm);

}  // namespace markerless_mocap
