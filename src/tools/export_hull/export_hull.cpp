#include "tools/export_hull/export_hull.h"

#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "clouds/cloud_file.h"
#include "ros/hull_conversions.h"
#include "text/joined.h"
#include "text/printable.h"
#include "tools/common/bag_io.h"

namespace markerless_mocap {
namespace {

/// "hull.ply" -> "hull_12.034000000.ply"
std::string withStamp(const std::filesystem::path& path, const ros::Time& stamp) {
  std::ostringstream name;
  name << path.stem().string() << '_' << stamp << path.extension().string();
  return (path.parent_path() / name.str()).string();
}

/// Throws std::runtime_error with those that there are if the topic is not one of them.
void checkTopic(const rosbag::Bag& bag, const std::string& topic) {
  rosbag::View clouds(bag, rosbag::TypeQuery("sensor_msgs/PointCloud2"));
  std::vector<std::string> topics;
  for (const rosbag::ConnectionInfo* cloud : clouds.getConnections()) {
    if (cloud->topic == topic) return;
    topics.push_back(cloud->topic);
  }
  throw std::runtime_error(
      bag.getFileName() + " has no point clouds on the topic " + quoted(topic) +
      (topics.empty() ? ", and none on others" : ", it has them on " + joined(topics)));
}

}  // namespace

std::vector<std::string> exportHulls(const HullExportOptions& what) {
  const std::filesystem::path output(what.output);
  if (output.extension() != ".pcd" && output.extension() != ".ply")
    throw std::invalid_argument("output is " + what.output +
                                ", allowed are names that end in .pcd or .ply");
  rosbag::Bag bag;
  openForReading(what.input, bag);
  checkTopic(bag, what.topic);
  const std::string grid_topic = std::filesystem::path(what.topic).parent_path() / "grid";
  const VoxelGrid grid = firstMessage<VoxelGrid>(bag, grid_topic);
  std::vector<std::string> files;
  std::optional<ros::Time> first;
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(what.topic))) {
    const auto cloud = messageOf<sensor_msgs::PointCloud2>(entry);
    if (!cloud) continue;
    if (!first) first = cloud->header.stamp;
    if ((cloud->header.stamp - *first).toSec() < what.at) continue;
    const VisualHull hull = hullFromMessage(*cloud, grid);
    if (hull.voxels.empty()) continue;
    files.push_back(what.all ? withStamp(output, cloud->header.stamp) : what.output);
    writeCloudFile(files.back(), hull, what.ascii);
    if (!what.all) break;
  }
  if (files.empty())
    throw std::runtime_error(what.input + " has no hull with voxels on " + what.topic +
                             (what.at > 0 ? " from that time on" : ""));
  return files;
}

}  // namespace markerless_mocap
