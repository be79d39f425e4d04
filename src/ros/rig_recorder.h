#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <tf2/buffer_core.h>

#include <memory>
#include <string>
#include <vector>

#include "checks/seen_rig.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {

/// How much of an image message is looked at.
struct ImageDetail {
  bool pixels = true;    ///< colours and silhouette
  bool picture = false;  ///< the whole picture is kept, too
};

/// Turns the messages of one camera into what checkRig() looks at. Not thread-safe; one object per
/// camera.
class CameraRecorder {
 public:
  /// \param masks the images are silhouettes
  CameraRecorder(const std::string& name, const SilhouetteOptions& silhouette, bool masks);

  void add(const sensor_msgs::CameraInfo& info, int64_t received_ns);
  void add(const sensor_msgs::Image& image, int64_t received_ns, const ImageDetail& detail);
  void add(const sensor_msgs::CompressedImage& image, int64_t received_ns,
           const ImageDetail& detail);
  /// For silhouettes; nullptr: learns from the images.
  void useBackground(const SharedBackground& background);

  const SeenCamera& seen() const { return seen_; }
  /// Takes the calibration from a rig file; camera_info and tf are passed over.
  void useCalibration(const CameraCalibration& calibration);
  /// What has been seen, with the pose that tf has now.
  SeenCamera seen(const tf2::BufferCore& tf, const std::string& world_frame) const;
  /// Forgets images received before this time, and pictures and changes of camera_info likewise.
  void forgetBefore(int64_t received_ns);

 private:
  /// \param decode gives the pixels; called only if they are wanted
  template <class Decode>
  void keep(SeenImage seen, const ImageDetail& detail, const Decode& decode);
  void addPixels(const cv::Mat& image, const ImageDetail& detail, SeenImage* seen);
  void findOutline(const cv::Mat& small, SeenImage* seen);

  SeenCamera seen_;
  bool has_rig_file_ = false;
  SilhouetteExtractor extractor_;
  cv::Size mask_size_;
};

/// An image at a width of at most kPictureWidth, as silhouettes are looked for in it.
cv::Mat checkedSize(const cv::Mat& image);

}  // namespace markerless_mocap
