#pragma once

#include <rosbag/bag.h>

#include <string>
#include <vector>

namespace markerless_mocap {

/// Topics of one camera in a recording; an empty name where the recording has none.
struct RecordedCamera {
  std::string name;              ///< namespace of its topics without the leading slash
  std::string info_topic;        ///< sensor_msgs/CameraInfo
  std::string image_topic;       ///< sensor_msgs/Image or sensor_msgs/CompressedImage
  std::string silhouette_topic;  ///< sensor_msgs/Image mono8
  std::string frame;             ///< optical frame, as camera_info names it
};

/// Finds cameras by their topics <camera>/camera_info, image_raw, image_raw/compressed (used where
/// there is no image_raw) and silhouette; sorted by name. Throws std::runtime_error with one
/// sentence: no camera at all, a chosen camera that is not in the recording, or one without
/// images and silhouettes or, unless the calibration comes from elsewhere, without camera_info.
/// \param chosen names to use, in this order; empty: all
std::vector<RecordedCamera> findCameras(rosbag::Bag& bag, const std::vector<std::string>& chosen,
                                        bool calibrated_elsewhere = false);

}  // namespace markerless_mocap
