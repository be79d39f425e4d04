#pragma once

#include <cstdint>
#include <future>
#include <optional>
#include <vector>

#include "contour/fit/contour_fitter.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {

/// Collects frames of different poses and estimates the shape of the person from them, once.
class OnlineShapeEstimator {
 public:
  /// \param poses number of frames that the estimate uses
  /// \param in_background the estimate runs in a thread of its own
  OnlineShapeEstimator(const CameraRig& rig, const ContourOptions& contour, const ShapePrior& prior,
                       int poses, bool in_background);

  /// The stature that the estimate starts with, metres.
  void setStature(double stature) { prior_.stature = stature; }
  /// Adds a frame if its pose differs from the last one added, or if some time has passed. The
  /// estimate starts as soon as there are enough poses, or after some seconds with fewer.
  void add(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
           const ContourFit& fit);
  /// A frame whose pose is not to be added has passed.
  void skip(int64_t stamp_ns);
  /// Estimates from the frames added so far, if there are any.
  void estimateNow();
  /// Number of frames added so far.
  int poses() const { return int(samples_.size()); }
  bool isEstimating() const { return estimate_.valid(); }
  /// The estimated shape parameters; empty as long as there are none.
  std::optional<ShapeParameters> shape();

 private:
  CameraRig rig_;
  ContourOptions contour_;
  ShapePrior prior_;
  size_t poses_;
  bool in_background_;
  std::vector<ShapeSample> samples_;
  Eigen::Matrix3Xd last_points_;
  int64_t first_stamp_ns_ = 0, last_stamp_ns_ = 0;
  std::future<ShapeParameters> estimate_;
};

}  // namespace markerless_mocap
