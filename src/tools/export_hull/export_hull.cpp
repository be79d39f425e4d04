#include "tools/export_hull/export_hull.h"

#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "ros/hull_conversions.h"
#include "ros/package_files.h"
#include "tools/common/bag_io.h"

namespace markerless_mocap {
namespace {

template <class Value>
void append(const Value& value, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Six significant digits resolve a voxel of 5 mm within 100 m.
std::string positionText(const Eigen::Vector3f& p) {
  std::ostringstream text;
  text.precision(6);
  text << p.x() << ' ' << p.y() << ' ' << p.z();
  return text.str();
}

std::string fileOf(const VisualHull& hull, const HullExportOptions& what) {
  const std::string kind = std::filesystem::path(what.output).extension();
  return kind == ".pcd" ? pcdOf(hull, what.ascii) : plyOf(hull, what.ascii);
}

/// "hull.ply" -> "hull_12.034000000.ply"
std::string withStamp(const std::filesystem::path& path, const ros::Time& stamp) {
  std::ostringstream name;
  name << path.stem().string() << '_' << stamp << path.extension().string();
  return (path.parent_path() / name.str()).string();
}

}  // namespace

std::string pcdOf(const VisualHull& hull, bool ascii) {
  std::ostringstream out;
  out << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb views\n"
      << "SIZE 4 4 4 4 1\nTYPE F F F U U\nCOUNT 1 1 1 1 1\nWIDTH " << hull.voxels.size()
      << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << hull.voxels.size() << "\nDATA "
      << (ascii ? "ascii" : "binary") << '\n';
  std::string bytes;
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3f p = hull.lattice.center(voxel.index).cast<float>();
    const uint32_t rgb =
        uint32_t(voxel.rgb[0]) << 16 | uint32_t(voxel.rgb[1]) << 8 | uint32_t(voxel.rgb[2]);
    if (ascii) {
      out << positionText(p) << ' ' << rgb << ' ' << int(voxel.views) << '\n';
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) append(p[axis], &bytes);
    append(rgb, &bytes);
    append(voxel.views, &bytes);
  }
  return out.str() + bytes;
}

std::string plyOf(const VisualHull& hull, bool ascii) {
  std::ostringstream out;
  out << "ply\nformat " << (ascii ? "ascii" : "binary_little_endian") << " 1.0\nelement vertex "
      << hull.voxels.size() << '\n';
  for (const char* axis : {"x", "y", "z"}) out << "property float " << axis << '\n';
  for (const char* name : {"red", "green", "blue", "views"})
    out << "property uchar " << name << '\n';
  out << "end_header\n";
  std::string bytes;
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3f p = hull.lattice.center(voxel.index).cast<float>();
    if (ascii) {
      out << positionText(p);
      for (const uint8_t value : voxel.rgb) out << ' ' << int(value);
      out << ' ' << int(voxel.views) << '\n';
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) append(p[axis], &bytes);
    for (const uint8_t value : voxel.rgb) append(value, &bytes);
    append(voxel.views, &bytes);
  }
  return out.str() + bytes;
}

std::vector<std::string> exportHulls(const HullExportOptions& what) {
  const std::filesystem::path output(what.output);
  if (output.extension() != ".pcd" && output.extension() != ".ply")
    throw std::invalid_argument("output is " + what.output +
                                ", allowed are names that end in .pcd or .ply");
  rosbag::Bag bag;
  openForReading(what.input, bag);
  const std::string grid_topic = std::filesystem::path(what.topic).parent_path() / "grid";
  const VoxelGrid grid = firstMessage<VoxelGrid>(bag, grid_topic);
  std::vector<std::string> files;
  std::optional<ros::Time> first;
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(what.topic))) {
    const auto cloud = entry.instantiate<sensor_msgs::PointCloud2>();
    if (!cloud) continue;
    if (!first) first = cloud->header.stamp;
    if ((cloud->header.stamp - *first).toSec() < what.at) continue;
    const VisualHull hull = hullFromMessage(*cloud, grid);
    if (hull.voxels.empty()) continue;
    files.push_back(what.all ? withStamp(output, cloud->header.stamp) : what.output);
    writeText(files.back(), fileOf(hull, what));
    if (!what.all) break;
  }
  if (files.empty())
    throw std::runtime_error("the bag has no hull with voxels on " + what.topic +
                             (what.at > 0 ? " from that time on" : ""));
  return files;
}

}  // namespace markerless_mocap
