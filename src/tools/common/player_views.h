#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"
#include "pages/every_nth.h"
#include "pages/page.h"

namespace markerless_mocap {

/// The person in the views of some frames, for a page: a small image and the outlines of body and
/// mask in it, cropped to both.
class PlayerViews {
 public:
  /// \param images false: outlines only, no picture of the person
  explicit PlayerViews(bool images = true) : images_(images) {}

  bool wants(size_t frame) const { return views_.wants(frame); }
  void halveFrames() { views_.halveFrames(); }  ///< see EveryNth
  /// \param masks one per camera; may be empty mats \param bodies silhouettes of the body, one per
  ///   camera, or none at all
  void add(size_t frame, const CameraRig& rig, const std::vector<CameraFrame>& frames,
           const std::vector<cv::Mat>& masks, const std::vector<cv::Mat>& bodies);
  /// [{"frame", "cameras": [{"aspect", "jpeg", "body", "mask", "unknown"}]}]: height by width;
  /// base64 of a JPEG, empty: none; outlines as base64 of 16-bit integers: for each polygon the
  /// number of its corners, then x and y of each in 1/2048 of the width.
  Json json() const;

 private:
  Json viewOf(const Camera& camera, const CameraFrame& frame, const cv::Mat& mask,
              const cv::Mat& body) const;

  bool images_;
  static constexpr size_t kMaxBytes = 17'000'000;
  EveryNth<Json> views_{kMaxBytes};
};

}  // namespace markerless_mocap
