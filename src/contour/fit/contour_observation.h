#pragma once

#include <Eigen/Core>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/contour/contour_options.h"

namespace markerless_mocap {

/// The viewing ray of a point on a silhouette's border, which touches the person somewhere. Points
/// are measured in the plane across the ray: along the border's outward normal and along the
/// border.
struct ContourRay {
  Eigen::Vector3f normal, side;      ///< unit, across the ray and each other, world
  float normal_of_ray, side_of_ray;  ///< of the ray itself in these coordinates, metres
  int camera;
  Eigen::Vector2f pixel;  ///< on the border between two pixels
};

enum class ViewStatus { kMissing, kEmpty, kFull, kUsable };
const char* toString(ViewStatus status);

/// What one camera's mask says, over a box around the person.
struct ContourView {
  ViewStatus status = ViewStatus::kMissing;
  int step = 1;      ///< pixels between samples
  cv::Point corner;  ///< pixel of the first sample / step
  cv::Mat person;    ///< CV_8UC1, the mask at the samples, 0 | 255
  /// CV_32FC1: pixels to the person's border, negative inside.
  cv::Mat distance;
};

/// All cameras at one instant.
struct ContourObservation {
  std::vector<ContourView> views;  ///< by camera
  std::vector<ContourRay> rays;    ///< evenly over all contours
  int usableViews() const;
};

class RayTable;

/// Turns masks into what a body is fitted to. Immutable; safe to share between threads.
class ContourObserver {
 public:
  /// Throws std::invalid_argument if the options do or there is no camera.
  ContourObserver(const CameraRig& rig, const ContourOptions& options);
  ~ContourObserver();
  const CameraRig& rig() const { return rig_; }

  /// \param masks by camera, CV_8UC1, non-zero = person, of the camera's size; one without data is
  ///   a camera that says nothing. Throws std::invalid_argument otherwise. Masks without person or
  ///   without background are left out and say so. The result does not depend on thread count.
  ContourObservation observe(const std::vector<cv::Mat>& masks) const;

 private:
  CameraRig rig_;
  int rays_;
  std::vector<RayTable> pixel_rays_;  ///< by camera
};

}  // namespace markerless_mocap
