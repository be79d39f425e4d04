#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "contour/fit/contour_fitter.h"

namespace markerless_mocap {

/// Tells the contours of things that stand still from those of a living person, who always moves a
/// little: by the temporal deviation of the brightness at the contour over some seconds. A chair
/// that the person sits on belongs to the silhouettes, and limbs would be fitted to it.
///
/// Limbs may rest, too. So still contours only count less than others, and only while there are
/// many of them that the body does not explain. Of a camera without images its masks are watched.
/// Not thread-safe.
class StillContours {
 public:
  explicit StillContours(const CameraRig& rig) : rig_(rig), views_(rig.size()) {}
  const CameraRig& rig() const { return rig_; }
  void reset();

  /// \param images by camera, CV_8UC1 or CV_8UC3, empty where missing
  /// \param masks by camera, CV_8UC1, empty where missing
  void watch(int64_t stamp_ns, const std::vector<cv::Mat>& images,
             const std::vector<cv::Mat>& masks);

  /// Reduces the weight of rays on still contours while furniture is suspected.
  void weigh(ContourObservation& seen) const;

  /// Updates whether furniture is suspected: from the still rays that a fit does not explain.
  void compare(const ContourObservation& seen, const ContourBody& body, const ContourPose& pose);

  /// True if a part of the contours moves: they are not those of furniture alone.
  bool showLife(const ContourObservation& seen) const;

 private:
  /// Brightness of one camera over time, sampled.
  struct View {
    int step = 1;               ///< pixels between samples
    cv::Mat mean, variance;     ///< CV_32FC1
    cv::Mat still;              ///< CV_8UC1, 255 where nothing moves
    bool shows_images = false;  ///< not masks
    int frames = 0;
    int64_t first_ns = 0, last_ns = 0;
  };
  void add(int64_t stamp_ns, const cv::Mat& image, View& view) const;
  bool moves(const ContourRay& ray) const;
  bool isStill(const ContourRay& ray) const;

  CameraRig rig_;
  std::vector<View> views_;
  double unexplained_ = 0.0;  ///< still rays without explanation, smoothed fraction of all rays
  bool suspected_ = false;
};

}  // namespace markerless_mocap
