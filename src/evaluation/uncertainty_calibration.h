#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Frames of like expected error. Where it means what it says, the two figures are one.
struct UncertaintyBin {
  size_t frames;
  double expected_mm, actual_mm;  ///< root mean squares
};

/// Whether the error that a tracker expects of a point is the one it makes.
struct UncertaintyCalibration {
  std::string point;
  size_t frames = 0;              ///< with both
  double expected_mm, actual_mm;  ///< root mean squares; NaN without frames
  /// Of the frames whose error is at most twice the expected one.
  double fraction_within_two_sigma;
  std::vector<UncertaintyBin> bins;  ///< fifths of the frames, by expected error ascending
};

/// \param expected_m standard deviation of the point as told, metres, per frame; NaN: not told
/// \param error_mm distance to the true point, mm; NaN without estimate
/// Throws std::invalid_argument unless both are of the same frames.
UncertaintyCalibration uncertaintyCalibration(const std::string& point,
                                              const std::vector<double>& expected_m,
                                              const std::vector<double>& error_mm);

}  // namespace markerless_mocap
