#pragma once

#include <ros/subscriber.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "nodes/common/stage_inputs.h"
#include "nodes/common/stamp_cache.h"
#include "nodes/pose_fitting/color_demand.h"

namespace markerless_mocap {

/// Colour images of the cameras whose background is not known, or whose masks are in doubt. A
/// camera is subscribed while that is so, and some seconds longer; grey cameras are left alone.
class ColorImages {
 public:
  /// \param inputs must outlive this object
  /// \param arrived called after each image
  ColorImages(std::vector<std::string> cameras, std::string transport, StageInputs* inputs,
              StageStatus* status, std::function<void()> arrived);

  /// To be called for each mask, before it is used. \param needs_colors its background is unknown,
  /// or it is in doubt
  void noteMask(size_t camera, int64_t stamp_ns, bool needs_colors);
  bool isNeeded(size_t camera, int64_t stamp_ns) const {
    return demand_.isNeeded(camera, stamp_ns);
  }
  /// True for a short time after the first images have been asked for: none has come yet.
  bool areAwaited(size_t camera, int64_t stamp_ns) const;
  /// True if the image of this time is needed and may still arrive.
  bool mayStillCome(size_t camera, int64_t stamp_ns, int64_t tolerance_ns,
                    int64_t max_behind_ns) const;
  /// Removes and returns the image with this stamp; empty if there is none.
  CameraImage take(size_t camera, int64_t stamp_ns) { return images_.take(camera, stamp_ns); }

 private:
  void receive(size_t camera, const CameraImage& image);
  /// Returns whether the image is in colour. An image that cannot be read counts as grey only here.
  bool isColor(size_t camera, const CameraImage& image);
  void subscribe(size_t camera);
  void unsubscribe(size_t camera);

  std::vector<std::string> cameras_;
  std::string transport_;
  StageInputs* inputs_;
  StageStatus* status_;
  std::function<void()> arrived_;
  ColorDemand demand_;
  StampCache<CameraImage> images_;
  std::vector<bool> known_to_be_color_;       ///< by camera
  std::vector<ros::Subscriber> subscribers_;  ///< by camera
  /// By camera: stamp of the mask that asked for images, until one comes.
  std::vector<std::optional<int64_t>> asked_ns_;
};

}  // namespace markerless_mocap
