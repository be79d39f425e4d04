#pragma once

#include <memory>
#include <vector>

#include "contour/contour_urdf_converter.h"
#include "contour/regions/region_observer.h"
#include "contour/self_calibration.h"
#include "markerless_mocap/tracking/body_tracker.h"

namespace markerless_mocap {

/// Collects frames of different postures, distributed over a whole recording, for the refinement of
/// the camera orientations. Where the background is unknown, colours around the pose decide what
/// the person's contours are. Not thread-safe.
class OrientationSampler {
 public:
  /// \param rig that may be wrong \param body of the poses
  /// \param max_samples at least 2; when there are so many, every second one is removed
  /// Throws std::invalid_argument as RegionObserver.
  OrientationSampler(const CameraRig& rig, const ContourOptions& contour, const TrackedBody& body,
                     size_t max_samples = 48);

  /// Frames come in the order of time. \param images, masks by camera, as of TrackerInput
  /// \param pose of the person in this frame; may be lost
  void add(const std::vector<cv::Mat>& images, const std::vector<cv::Mat>& masks,
           const BodyPose& pose);
  const std::vector<OrientationSample>& samples() const { return samples_; }

 private:
  bool isAnotherPosture(const ContourPose& pose);
  void thinOut();

  RegionObserver observer_;
  ContourUrdfConverter converter_;
  ContourBody body_;
  Eigen::Matrix3Xd last_;  ///< points of the body in the last posture that counted
  size_t max_samples_, postures_ = 0, stride_ = 1;
  std::vector<OrientationSample> samples_;
};

}  // namespace markerless_mocap
