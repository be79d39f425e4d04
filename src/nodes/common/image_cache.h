#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "nodes/common/camera_image.h"

namespace markerless_mocap {

/// The last images of each camera, found again by their stamp.
class ImageCache {
 public:
  explicit ImageCache(size_t cameras) : images_(cameras) {}

  void add(size_t camera, const CameraImage& image);
  /// nullptr if it is not there.
  const CameraImage* find(size_t camera, int64_t stamp_ns) const;
  /// Whether the camera sends images and the one of this stamp may still come.
  bool mayStillCome(size_t camera, int64_t stamp_ns) const;

 private:
  std::vector<std::map<int64_t, CameraImage>> images_;
};

}  // namespace markerless_mocap
