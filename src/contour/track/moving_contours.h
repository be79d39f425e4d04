#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "contour/fit/contour_observation.h"

namespace markerless_mocap {

/// Tells the contours of things that stand still from those of a living person, who always moves a
/// little: by the temporal deviation of the brightness at the contour over some seconds. Of a
/// camera without images its masks are watched. Not thread-safe.
class MovingContours {
 public:
  explicit MovingContours(size_t cameras) : views_(cameras) {}
  void reset() { views_.assign(views_.size(), {}); }

  /// \param images by camera, CV_8UC1 or CV_8UC3, empty where missing
  /// \param masks by camera, CV_8UC1, empty where missing
  void watch(int64_t stamp_ns, const std::vector<cv::Mat>& images,
             const std::vector<cv::Mat>& masks);

  /// True if a part of the contours moves: they are not those of furniture alone.
  bool showLife(const ContourObservation& seen) const;

 private:
  /// Brightness of one camera over time, sampled.
  struct View {
    int step = 1;               ///< pixels between samples
    cv::Mat mean, variance;     ///< CV_32FC1
    cv::Mat moving;             ///< CV_8UC1, 255 where something near moves
    bool shows_images = false;  ///< not masks
    int frames = 0;
    int64_t last_ns = 0;
  };
  static void add(int64_t stamp_ns, const cv::Mat& image, View& view);
  bool moves(const ContourRay& ray) const;

  std::vector<View> views_;
};

}  // namespace markerless_mocap
