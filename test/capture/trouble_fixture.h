#pragma once

#include <opencv2/core.hpp>

#include "capture/studio_fixture.h"

namespace markerless_mocap {

/// No trouble at all, a small rig.
inline StudioOptions easyStudio() {
  StudioOptions options = smallStudio();
  options.background_frames = 1;
  DegradationOptions& all = options.degradations;
  all.noise_stddev = all.flicker = all.shadow_strength = 0.0;  // the others are off
  return options;
}

inline StudioOptions with(double DegradationOptions::*trouble, double value) {
  StudioOptions options = easyStudio();
  options.degradations.*trouble = value;
  return options;
}

inline VirtualStudio studio(const StudioOptions& options) {
  return VirtualStudio(options, packageFiles(), "person1");
}

/// Mean absolute difference of the pixels that `where` marks.
inline double meanDifference(const cv::Mat& a, const cv::Mat& b, const cv::Mat& where) {
  cv::Mat apart;
  cv::absdiff(a, b, apart);
  const cv::Scalar mean = cv::mean(apart, where);
  return (mean[0] + mean[1] + mean[2]) / 3.0;
}

}  // namespace markerless_mocap
