#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "contour/model/contour_body.h"
#include "markerless_mocap/camera/camera.h"
#include "region/region_segmenter.h"

namespace markerless_mocap {

/// True if colours must decide in a view: its background is not known where it matters, and there
/// is a colour image.
/// \param mask CV_8UC1 0 | 128 unknown | 255, or empty
bool needsRegions(const cv::Mat& image, const cv::Mat& mask);

/// Masks of all cameras.
struct RegionMasks {
  std::vector<cv::Mat> masks;  ///< by camera, CV_8UC1, of the size of the image
  /// Fraction of the person found by colours that background subtraction sees as person, too, where
  /// it knows the background; 0 if it knows none there, 1 if no view needs colours.
  double agreement = 1.0;
};

/// Masks from colours around a predicted pose, for all cameras. It is used where background
/// subtraction does not know the background. Not thread-safe.
class BodyRegions {
 public:
  explicit BodyRegions(const CameraRig& rig);
  bool hasColors() const;
  /// Forgets the colours of the person.
  void reset();

  /// \param images by camera, CV_8UC3 BGR; others are not used
  /// \param masks by camera, CV_8UC1 0 | 128 unknown | 255, or empty
  /// \param error_m expected error of the body's outline, metres
  /// \return a view that needs no regions has its mask
  RegionMasks segment(const std::vector<cv::Mat>& images, const std::vector<cv::Mat>& masks,
                      const ContourBody& body, const ContourPose& pose, double error_m) const;
  /// Learns the colours of the person and of the surroundings from a pose that is believed.
  void learn(const std::vector<cv::Mat>& images, const std::vector<cv::Mat>& masks,
             const ContourBody& body, const ContourPose& pose, double error_m);

 private:
  CameraRig rig_;
  std::vector<RegionSegmenter> segmenters_;  ///< by camera
};

}  // namespace markerless_mocap
