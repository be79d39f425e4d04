#pragma once

#include <array>
#include <future>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "contour/model/contour_body.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/visual_hull.h"
#include "region/region_view.h"

namespace markerless_mocap {

/// The masks of one frame set, and colours where masks alone do not tell: where the background is
/// not known where it matters, and there is a colour image.
struct RegionFrame {
  std::vector<cv::Mat> masks;     ///< by camera, CV_8UC1 0 | 128 unknown | 255, or empty
  std::vector<RegionView> views;  ///< by camera
  std::vector<bool> tells;        ///< by camera: the mask alone shows the person
  bool is_coarse = false;

  RegionFrame() = default;
  /// \param images by camera; missing ones may be empty or left out at the end
  RegionFrame(const std::vector<cv::Mat>& images, const std::vector<cv::Mat>& masks);
  /// The same with half as many samples along each axis where there are colours.
  RegionFrame coarser() const;
  /// A copy that shares no pixels.
  RegionFrame clone() const;
  /// True if colours decide in a view.
  bool needsColors() const;
};

/// Masks of all cameras, and how well background subtraction agrees with them, in views where
/// colours decided.
struct RegionMasks {
  std::vector<cv::Mat> masks;  ///< by camera, CV_8UC1, of the size of the image
  /// Fraction of the person found by colours that background subtraction sees as person, too; 1 if
  /// no view needed colours or nothing is known there.
  double agreement = 1.0;
  /// Fraction of each limb found by colours that background subtraction does not see as background.
  /// Of a limb in front of an unknown background, the few known samples at its border mean nothing.
  std::array<double, ContourLimb::kCount> limb_agreement;
  /// Intersection over union of the person found by colours and the silhouettes; 1 if no view
  /// needed colours.
  double overlap = 1.0;
};

/// Masks from colours around a predicted pose, for all cameras. It is used where background
/// subtraction does not know the background. Not thread-safe.
class BodyRegions {
 public:
  explicit BodyRegions(const CameraRig& rig);
  const CameraRig& rig() const { return rig_; }
  /// Forgets the colours of the person.
  void reset();

  /// \param error_m expected error of the body's outline, metres
  /// \return a view without colours has its mask; one in which background subtraction contradicts
  /// the colours, while most views do not, is all unknown
  RegionMasks segment(const RegionFrame& frame, const ContourBody& body, const ContourPose& pose,
                      double error_m) const;
  /// Where the person is or may be: a view without colours has its mask, others show samples near
  /// the body that background subtraction sees as person, or that have colours of the person where
  /// the background is unknown. Of them those that the hull projects into: other views agree.
  /// \param hull of the same frame set; an empty one excludes nothing
  std::vector<cv::Mat> candidates(const RegionFrame& frame, const VisualHull& hull,
                                  const ContourBody& body, const ContourPose& pose) const;
  /// The largest that the person can be: a view without colours has its mask, others show all
  /// pixels that are not known background and that the hull projects into. \param hull of the same
  /// frame set; an empty one excludes nothing
  std::vector<cv::Mat> largest(const RegionFrame& frame, const VisualHull& hull) const;
  /// Learns the colours of the person and of the surroundings from a pose that is believed.
  void learn(const RegionFrame& frame, const ContourBody& body, const ContourPose& pose,
             double error_m);

 private:
  CameraRig rig_;
  std::shared_future<void> prepared_;        ///< beside what comes before the first search
  std::vector<RegionSegmenter> segmenters_;  ///< by camera
};

}  // namespace markerless_mocap
