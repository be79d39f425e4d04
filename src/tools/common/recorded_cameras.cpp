#include "tools/common/recorded_cameras.h"

#include <rosbag/view.h>

#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "text/joined.h"

namespace markerless_mocap {
namespace {

constexpr const char* kInfo = "sensor_msgs/CameraInfo";
constexpr const char* kImage = "sensor_msgs/Image";
/// Topics of the ground truth, which belong to no camera.
constexpr const char* kTruth = "/ground_truth/";
constexpr const char* kCompressed = "sensor_msgs/CompressedImage";

/// The name of the camera if the topic has this suffix and type.
std::optional<std::string> cameraOf(const std::string& topic, const std::string& datatype,
                                    const std::string& suffix, const char* type) {
  if (datatype != type || topic.size() <= suffix.size()) return std::nullopt;
  if (topic.rfind(kTruth, 0) == 0) return std::nullopt;
  const size_t stem = topic.size() - suffix.size();
  if (topic.compare(stem, suffix.size(), suffix) != 0) return std::nullopt;
  const size_t first = topic.front() == '/' ? 1 : 0;
  return topic.substr(first, stem - first);
}

using CamerasByName = std::map<std::string, RecordedCamera>;

void noteTopic(const std::string& topic, const std::string& type, CamerasByName* cameras) {
  if (const auto name = cameraOf(topic, type, "/camera_info", kInfo))
    (*cameras)[*name].info_topic = topic;
  if (const auto name = cameraOf(topic, type, "/image_raw", kImage))
    (*cameras)[*name].image_topic = topic;
  if (const auto name = cameraOf(topic, type, "/silhouette", kImage))
    (*cameras)[*name].silhouette_topic = topic;
  if (const auto name = cameraOf(topic, type, "/image_raw/compressed", kCompressed)) {
    RecordedCamera& camera = (*cameras)[*name];
    if (camera.image_topic.empty()) camera.image_topic = topic;
  }
}

std::string namesOf(const CamerasByName& cameras) {
  return joined(cameras, [](const auto& entry) { return entry.first; });
}

void checkCamera(const RecordedCamera& camera, bool calibrated_elsewhere) {
  if (camera.info_topic.empty() && !calibrated_elsewhere)
    throw std::runtime_error("camera " + camera.name + " has images but no topic " + camera.name +
                             "/camera_info in the bag");
  if (camera.image_topic.empty() && camera.silhouette_topic.empty())
    throw std::runtime_error("camera " + camera.name +
                             " has neither image_raw, image_raw/compressed nor silhouette in the "
                             "bag");
}

std::vector<RecordedCamera> choose(const CamerasByName& cameras,
                                   const std::vector<std::string>& chosen) {
  std::vector<RecordedCamera> out;
  std::set<std::string> seen;
  for (const std::string& name : chosen) {
    const auto found = cameras.find(name);
    if (found == cameras.end())
      throw std::runtime_error("camera " + name + " is not in the bag, it has " + namesOf(cameras));
    if (!seen.insert(name).second) throw std::runtime_error("camera " + name + " is named twice");
    out.push_back(found->second);
  }
  return out;
}

}  // namespace

std::vector<RecordedCamera> listCameras(rosbag::Bag& bag, const std::vector<std::string>& chosen) {
  rosbag::View view(bag);
  std::map<std::string, std::string> topics;
  for (const rosbag::ConnectionInfo* connection : view.getConnections())
    topics[connection->topic] = connection->datatype;
  return listCameras(topics, chosen, "the bag");
}

std::vector<RecordedCamera> listCameras(const std::map<std::string, std::string>& types,
                                        const std::vector<std::string>& chosen,
                                        const std::string& where) {
  CamerasByName cameras;
  // Raw images precede compressed ones in the order of topics, so they are preferred.
  for (const auto& entry : types) noteTopic(entry.first, entry.second, &cameras);
  for (auto& entry : cameras) entry.second.name = entry.first;
  if (cameras.empty())
    throw std::runtime_error(
        where +
        " has no cameras: no topic <camera>/camera_info with <camera>/image_raw, "
        "<camera>/image_raw/compressed or <camera>/silhouette");
  std::vector<RecordedCamera> found = choose(cameras, chosen);
  if (chosen.empty())
    for (const auto& entry : cameras) found.push_back(entry.second);
  return found;
}

std::vector<RecordedCamera> findCameras(rosbag::Bag& bag, const std::vector<std::string>& chosen,
                                        bool calibrated_elsewhere) {
  const std::vector<RecordedCamera> found = listCameras(bag, chosen);
  for (const RecordedCamera& camera : found) checkCamera(camera, calibrated_elsewhere);
  return found;
}

}  // namespace markerless_mocap
