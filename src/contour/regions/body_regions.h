#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "contour/model/contour_body.h"
#include "markerless_mocap/camera/camera.h"
#include "region/region_segmenter.h"

namespace markerless_mocap {

/// Image of a camera; empty if there is none.
const cv::Mat& imageOf(const std::vector<cv::Mat>& images, size_t camera);

/// True if colours must decide in a view: its background is not known where it matters, and there
/// is a colour image.
/// \param mask CV_8UC1 0 | 128 unknown | 255, or empty
bool needsRegions(const cv::Mat& image, const cv::Mat& mask);

/// Masks of all cameras, and how well background subtraction agrees with them. Only views where
/// colours decided count, and of them only samples with a known background.
struct RegionMasks {
  std::vector<cv::Mat> masks;  ///< by camera, CV_8UC1, of the size of the image
  /// Fraction of the person found by colours that background subtraction sees as person, too, and
  /// the same of each limb; 1 if no view needed colours or nothing is known there.
  double agreement = 1.0;
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
  bool hasColors() const;
  /// Forgets the colours of the person.
  void reset();

  /// \param images by camera, CV_8UC3 BGR; others are not used
  /// \param masks by camera, CV_8UC1 0 | 128 unknown | 255, or empty
  /// \param error_m expected error of the body's outline, metres
  /// \return a view that needs no regions has its mask
  RegionMasks segment(const std::vector<cv::Mat>& images, const std::vector<cv::Mat>& masks,
                      const ContourBody& body, const ContourPose& pose, double error_m) const;
  /// Where the person is or may be: a view that needs no regions has its mask, others show samples
  /// near the body that background subtraction sees as person, or that have colours of the person.
  std::vector<cv::Mat> candidates(const std::vector<cv::Mat>& images,
                                  const std::vector<cv::Mat>& masks, const ContourBody& body,
                                  const ContourPose& pose) const;
  /// Learns the colours of the person and of the surroundings from a pose that is believed.
  void learn(const std::vector<cv::Mat>& images, const std::vector<cv::Mat>& masks,
             const ContourBody& body, const ContourPose& pose, double error_m);

 private:
  CameraRig rig_;
  std::vector<RegionSegmenter> segmenters_;  ///< by camera
};

}  // namespace markerless_mocap
