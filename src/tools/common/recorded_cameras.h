#pragma once

#include <rosbag/bag.h>

#include <map>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Topics of one camera in a recording; a name is empty if the topic does not exist.
struct RecordedCamera {
  std::string name;              ///< namespace of its topics without the leading slash
  std::string info_topic;        ///< sensor_msgs/CameraInfo
  std::string image_topic;       ///< sensor_msgs/Image or sensor_msgs/CompressedImage
  std::string silhouette_topic;  ///< sensor_msgs/Image mono8
  std::string frame;             ///< optical frame of camera_info
};

/// Finds cameras by their topics <camera>/camera_info, image_raw, image_raw/compressed (used if
/// there is no image_raw) and silhouette; sorted by name. Throws std::runtime_error if there is no
/// camera, if a chosen camera is not in the recording, or if a camera has neither images nor
/// silhouettes or, unless calibrated_elsewhere, no camera_info.
/// \param chosen names to use, in this order; empty: all
std::vector<RecordedCamera> findCameras(rosbag::Bag& bag, const std::vector<std::string>& chosen,
                                        bool calibrated_elsewhere = false);

/// As findCameras(), but a camera may lack anything: only a bag without cameras and names that are
/// not in it are errors.
std::vector<RecordedCamera> listCameras(rosbag::Bag& bag, const std::vector<std::string>& chosen);

/// The same of running topics. \param types of topics \param where for messages: "the bag"
std::vector<RecordedCamera> listCameras(const std::map<std::string, std::string>& types,
                                        const std::vector<std::string>& chosen,
                                        const std::string& where);

}  // namespace markerless_mocap
