#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <vector>

#include "calibration/lens.h"

namespace markerless_mocap {

/// What a pinhole camera of focal length 1 sees that stands where a fisheye does and looks at the
/// middle of some pixels.
struct AheadView {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< from its frame to the fisheye's
  std::vector<cv::Point2d> pixels;                     ///< of those that it sees
  std::vector<size_t> seen;                            ///< their indices
};

AheadView seenAhead(const Intrinsics& fisheye, const std::vector<cv::Point2d>& pixels);

}  // namespace markerless_mocap
