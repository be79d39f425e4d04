#include "clouds/cloud_file.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <filesystem>

#include "files/whole_file.h"
#include "markerless_mocap/ros/point_types.h"

namespace markerless_mocap {
namespace {

constexpr int kDigits = 6;  // resolve a voxel of 5 mm within 100 m

HullPoint pointOf(const VisualHull& hull, const HullVoxel& voxel) {
  HullPoint point;
  point.getVector3fMap() = hull.lattice.center(voxel.index).cast<float>();
  point.r = voxel.rgb[0], point.g = voxel.rgb[1], point.b = voxel.rgb[2];
  point.views = voxel.views;
  const ColorVotes& votes = voxel.color_votes;
  point.votes_x = votes.votes[0], point.votes_y = votes.votes[1], point.votes_z = votes.votes[2];
  point.possible_x = votes.possible[0], point.possible_y = votes.possible[1];
  point.possible_z = votes.possible[2];
  return point;
}

pcl::PCLPointCloud2 cloudOf(const VisualHull& hull) {
  pcl::PointCloud<HullPoint> points;
  for (const HullVoxel& voxel : hull.voxels) points.push_back(pointOf(hull, voxel));
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2(points, cloud);
  return cloud;
}

int writeWith(const std::string& path, const pcl::PCLPointCloud2& cloud, bool pcd, bool ascii) {
  const Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  const Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();
  if (pcd && ascii) return pcl::PCDWriter().writeASCII(path, cloud, origin, turn, kDigits);
  if (pcd) return pcl::PCDWriter().writeBinary(path, cloud, origin, turn);
  if (ascii) return pcl::PLYWriter().writeASCII(path, cloud, origin, turn, kDigits, false);
  return pcl::PLYWriter().writeBinary(path, cloud, origin, turn, false);
}

}  // namespace

void writeCloudFile(const std::string& path, const VisualHull& hull, bool ascii) {
  const bool pcd = std::filesystem::path(path).extension() == ".pcd";
  writeWholeFileBy(path, [&](const std::string& active) {
    try {
      return writeWith(active, cloudOf(hull), pcd, ascii) == 0;
    } catch (const pcl::IOException&) {
      return false;
    }
  });
}

}  // namespace markerless_mocap
