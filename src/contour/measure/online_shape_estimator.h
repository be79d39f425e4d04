#pragma once

#include <cstdint>
#include <future>
#include <optional>
#include <vector>

#include "contour/fit/contour_fitter.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {

/// Gathers instants of different poses and estimates the person's sizes from them, once.
class OnlineShapeEstimator {
 public:
  /// \param poses how many the estimate is made from
  /// \param in_background the estimate is made while instants go on
  OnlineShapeEstimator(const CameraRig& rig, const ContourOptions& contour, const ShapePrior& prior,
                       int poses, bool in_background);

  /// The stature that the estimate begins with, metres.
  void setStature(double stature) { prior_.stature = stature; }
  /// Takes an instant in if its pose has changed from the last one taken, or time has passed. The
  /// estimate begins with enough poses, or after a while with fewer.
  void add(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
           const ContourFit& fit);
  /// Estimates from the instants taken in so far, if there are any.
  void estimateNow();
  /// Instants taken in so far.
  int poses() const { return int(instants_.size()); }
  bool isEstimating() const { return estimate_.valid(); }
  /// The sizes, as soon as there are some.
  std::optional<ShapeParameters> sizes();

 private:
  CameraRig rig_;
  ContourOptions contour_;
  ShapePrior prior_;
  size_t poses_;
  bool in_background_;
  std::vector<ShapeSample> instants_;
  Eigen::Matrix3Xd last_points_;
  int64_t first_stamp_ns_ = 0, last_stamp_ns_ = 0;
  std::future<ShapeParameters> estimate_;
};

}  // namespace markerless_mocap
