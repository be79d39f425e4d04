#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {

/// What the stages made of one instant. All must outlive the call it is given to.
struct TrackerInput {
  int64_t stamp_ns;                    ///< capture time
  const std::vector<cv::Mat>& masks;   ///< by camera, CV_8UC1 0 | 255; empty where missing
  const std::vector<cv::Mat>& images;  ///< by camera, grey or BGR; empty where missing
  const VisualHull& hull;
  const BodyParts& parts;
  const PoseTree& tree;
};

/// Follows one person from frame set to frame set; every method is one. Not thread-safe.
class BodyTracker {
 public:
  virtual ~BodyTracker();
  /// \param now stamps that do not rise restart the track. Throws std::invalid_argument on masks or
  ///   images that do not fit the rig
  virtual BodyPose update(const TrackerInput& now) = 0;
  virtual void reset() = 0;
  /// Measures the body from what has been seen so far, however little, instead of waiting for more.
  virtual void estimateShapeNow() {}
  /// The person's body now; it changes when it has been measured, within update() only.
  virtual const std::shared_ptr<const TrackedBody>& body() const = 0;
};

}  // namespace markerless_mocap
