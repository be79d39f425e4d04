#pragma once

#include <Eigen/Core>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "contour/model/contour_body.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/contour/contour_options.h"

namespace markerless_mocap {

/// The viewing ray of a point on the contour of a silhouette. The ray touches the surface of the
/// person somewhere. Points near the ray have two coordinates in the plane perpendicular to it:
/// along the outward normal of the contour, and along the contour.
struct ContourRay {
  Eigen::Vector3f normal, side;      ///< unit vectors in the world, perpendicular to the ray and to
                                     ///< each other
  float normal_of_ray, side_of_ray;  ///< coordinates of the ray itself, metres
  int camera;
  Eigen::Vector2f pixel;  ///< between two pixels
};

/// kContradicted: left out, as it shows something else than most others do.
enum class ViewStatus { kMissing, kEmpty, kFull, kUsable, kContradicted };
const char* toString(ViewStatus status);

/// By how much the ends of the body's cones are elsewhere, metres.
struct ConeShift {
  Eigen::Vector3d a, b;
};
using ConeShifts = std::array<ConeShift, kContourCones>;

/// The mask of one camera, sampled in a box around the person.
struct ContourView {
  ViewStatus status = ViewStatus::kMissing;
  int step = 1;      ///< pixels between samples
  cv::Point corner;  ///< first sample: its pixel divided by step
  cv::Mat person;    ///< CV_8UC1, 0 | 255: the mask at the samples; unknown counts as person
  cv::Mat known;     ///< CV_8UC1, 0 unknown | 255; empty if all samples are known
  /// CV_32FC1: distance to the border of the silhouette, pixels, negative inside.
  cv::Mat distance;
  /// From the body at the time of the observation to the body that this view shows; null: the view
  /// is of that time.
  std::shared_ptr<const ConeShifts> shifts;
};

/// The silhouettes of all cameras at one time.
struct ContourObservation {
  std::vector<ContourView> views;  ///< by camera
  std::vector<ContourRay> rays;    ///< evenly distributed over all contours
  /// The masks were found by colours near a pose: that they lack a part of a limb tells little.
  bool masks_follow_pose = false;
  int usableViews() const;
};

class RayTable;

class PreparedViews;

/// Converts masks to the data that a body is fitted to. Safe to share between threads.
class ContourObserver {
 public:
  /// Throws std::invalid_argument if an option is out of range or the rig has no cameras.
  ContourObserver(const CameraRig& rig, const ContourOptions& options);
  ~ContourObserver();
  const CameraRig& rig() const { return rig_; }

  /// \param masks one per camera, CV_8UC1, 0 background, 128 unknown, other values person, of the
  ///   size of the camera's image, or empty if missing; else throws std::invalid_argument. A mask
  ///   without person or without background is not used, see ContourView::status. The result does
  ///   not depend on the number of threads.
  ContourObservation observe(const std::vector<cv::Mat>& masks) const;
  /// The same with a third of the rays, for a search.
  ContourObservation observeRoughly(const std::vector<cv::Mat>& masks) const;
  /// Samples a mask beforehand: observe() need not, if it gets a mask with the same pixels in
  /// memory before the camera's next one is prepared. Nothing is done with a mask that observe()
  /// would not take, or that has unknown pixels, which colours may replace.
  void prepare(size_t camera, const cv::Mat& mask) const;
  /// Throws as observe().
  void check(const std::vector<cv::Mat>& masks) const;

 private:
  ContourObservation observe(const std::vector<cv::Mat>& masks, int rays) const;

  CameraRig rig_;
  int rays_;
  std::vector<RayTable> pixel_rays_;  ///< by camera
  std::unique_ptr<PreparedViews> prepared_;
};

}  // namespace markerless_mocap
