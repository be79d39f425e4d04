#pragma once

#include <memory>
#include <mutex>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

#include "contour/fit/contour_observation.h"
#include "contour/fit/outline.h"

namespace markerless_mocap {

/// A view and the outline of its silhouette.
struct OutlinedView {
  ContourView view;
  std::vector<Crack> cracks;
};

/// What has been made of masks beforehand: the last one of each camera. Thread-safe.
class PreparedViews {
 public:
  using Pointer = std::shared_ptr<const OutlinedView>;

  explicit PreparedViews(size_t cameras) : by_camera_(cameras) {}

  void put(size_t camera, const cv::Mat& mask, Pointer view) {
    const std::lock_guard<std::mutex> lock(mutex_);
    by_camera_[camera] = {mask, std::move(view)};
  }
  /// Null if the last mask of the camera had its pixels elsewhere. That mask is kept, so that
  /// nothing else can be where they are.
  Pointer find(size_t camera, const cv::Mat& mask) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Entry& entry = by_camera_[camera];
    return entry.mask.data == mask.data && !mask.empty() ? entry.view : nullptr;
  }

 private:
  struct Entry {
    cv::Mat mask;
    Pointer view;
  };
  mutable std::mutex mutex_;
  std::vector<Entry> by_camera_;
};

}  // namespace markerless_mocap
