#pragma once

#include <functional>

namespace markerless_mocap {

/// The stature whose mean body fits best, metres: the expected one, or one of some usual ones. If
/// the best of these is the smallest or the largest, more are tried beyond, 1.2 to 2.35 m: a child,
/// or a calibration whose metre is wrong.
/// \param quality of the best fit at a stature in metres, see qualityOf()
double likelyStature(double expected, const std::function<double(double stature)>& quality);

struct RatedStature {
  double stature;  ///< metres
  double quality;
};

/// Larger statures in turn as long as each fits better, or else smaller ones, 1.1 to 2.4 m: for a
/// body that fits poorly.
/// \return the best one, or `from` if no other fits better
RatedStature betterStature(RatedStature from, const std::function<double(double stature)>& quality);

}  // namespace markerless_mocap
