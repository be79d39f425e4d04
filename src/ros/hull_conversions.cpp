#include "ros/hull_conversions.h"

#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "ros/aligned_points.h"
#include "ros/message_limits.h"
#include "ros/point_cloud_reader.h"
#include "text/printable.h"

namespace markerless_mocap {
namespace {

using sensor_msgs::PointField;
constexpr uint64_t kMaxGridVoxels = 64000000;  // as visual_hull
constexpr double kMaxPitch = 10.0;             // metres
constexpr const char* kByteFields[7] = {"views",      "votes_x",    "votes_y",   "votes_z",
                                        "possible_x", "possible_y", "possible_z"};

void checkFrame(const sensor_msgs::PointCloud2& cloud, const VoxelGrid& grid) {
  if (cloud.header.frame_id != grid.header.frame_id)
    throw std::invalid_argument("hull cloud is in the frame " + quoted(cloud.header.frame_id) +
                                ", allowed is the grid's " + quoted(grid.header.frame_id));
}

/// Linear index of the voxel with this centre.
uint32_t voxelAt(const VoxelLattice& lattice, const Eigen::Vector3d& point) {
  const Eigen::Vector3d cell = (point - lattice.origin) / lattice.pitch;
  const Eigen::Vector3d corner = cell.array().floor();
  const double off_center = (cell - corner - Eigen::Vector3d::Constant(0.5)).cwiseAbs().maxCoeff();
  const bool inside =
      (corner.array() >= 0.0).all() && (corner.array() < lattice.size.cast<double>().array()).all();
  if (!point.allFinite() || !inside || !(off_center < 0.1))
    throw std::invalid_argument("hull cloud does not lie on the grid: (" +
                                std::to_string(point.x()) + ", " + std::to_string(point.y()) +
                                ", " + std::to_string(point.z()) +
                                ") is not the centre of a voxel");
  const Eigen::Vector3i at = corner.cast<int>();
  return lattice.index(at.x(), at.y(), at.z());
}

void readVoxels(const PointCloudReader& cloud, VisualHull& hull) {
  const PointReader centers(cloud);
  const size_t rgb = cloud.offset("rgb", PointField::FLOAT32);
  std::array<size_t, 7> bytes;
  for (size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = cloud.offset(kByteFields[i], PointField::UINT8);
  hull.voxels.resize(cloud.size());
  for (size_t i = 0; i < cloud.size(); ++i) {
    HullVoxel& voxel = hull.voxels[i];
    voxel.index = voxelAt(hull.lattice, centers(i));
    for (size_t channel = 0; channel < 3; ++channel)  // packed as 0x00RRGGBB
      voxel.rgb[channel] = cloud.byte(i, rgb + 2 - channel);
    voxel.views = cloud.byte(i, bytes[0]);
    for (size_t axis = 0; axis < 3; ++axis) {
      voxel.color_votes.votes[axis] = cloud.byte(i, bytes[1 + axis]);
      voxel.color_votes.possible[axis] = cloud.byte(i, bytes[4 + axis]);
    }
  }
}

void sortVoxels(std::vector<HullVoxel>* voxels) {
  std::sort(voxels->begin(), voxels->end(),
            [](const HullVoxel& a, const HullVoxel& b) { return a.index < b.index; });
  const auto same = [](const HullVoxel& a, const HullVoxel& b) { return a.index == b.index; };
  if (std::adjacent_find(voxels->begin(), voxels->end(), same) != voxels->end())
    throw std::invalid_argument("hull cloud has a voxel twice");
}

bool isUsable(const VoxelGrid& grid) {
  uint64_t voxels = 1;
  for (const uint32_t size : grid.size) {  // checked before each product, so that none overflows
    if (size == 0 || size > kMaxGridVoxels / voxels) return false;
    voxels *= size;
  }
  return isPlace({grid.origin.x, grid.origin.y, grid.origin.z}) && grid.pitch > 0.0 &&
         grid.pitch <= kMaxPitch;
}

sensor_msgs::PointCloud2 emptyCloud(const std_msgs::Header& header, size_t points) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  cloud.height = 1;
  cloud.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  const auto f32 = PointField::FLOAT32;
  const auto u8 = PointField::UINT8;
  modifier.setPointCloud2Fields(11, "x", 1, f32, "y", 1, f32, "z", 1, f32, "rgb", 1, f32, "views",
                                1, u8, "votes_x", 1, u8, "votes_y", 1, u8, "votes_z", 1, u8,
                                "possible_x", 1, u8, "possible_y", 1, u8, "possible_z", 1, u8);
  alignPoints(&cloud);
  modifier.resize(points);
  return cloud;
}

}  // namespace

VoxelGrid messageFromLattice(const VoxelLattice& lattice, const std_msgs::Header& header) {
  VoxelGrid grid;
  grid.header = header;
  grid.origin = tf2::toMsg(lattice.origin);
  grid.pitch = lattice.pitch;
  for (int axis = 0; axis < 3; ++axis) grid.size[axis] = static_cast<uint32_t>(lattice.size[axis]);
  return grid;
}

VoxelLattice latticeFromMessage(const VoxelGrid& grid) {
  if (!isUsable(grid))
    throw std::invalid_argument(
        "voxel grid is unusable, allowed are an origin within 10 km, a pitch above 0 to 10 m, "
        "sizes of 1 or more and 64 million voxels");
  VoxelLattice lattice;
  lattice.origin = {grid.origin.x, grid.origin.y, grid.origin.z};
  lattice.pitch = grid.pitch;
  for (int axis = 0; axis < 3; ++axis) lattice.size[axis] = static_cast<int>(grid.size[axis]);
  return lattice;
}

sensor_msgs::PointCloud2 messageFromHull(const VisualHull& hull, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 cloud = emptyCloud(header, hull.voxels.size());
  sensor_msgs::PointCloud2Iterator<float> xyz(cloud, "x");
  sensor_msgs::PointCloud2Iterator<uint8_t> r(cloud, "r"), g(cloud, "g"), b(cloud, "b");
  sensor_msgs::PointCloud2Iterator<uint8_t> bytes(cloud, "views");  // the seven uint8 fields
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3f center = hull.lattice.center(voxel.index).cast<float>();
    std::copy_n(center.data(), 3, &xyz[0]);
    *r = voxel.rgb[0], *g = voxel.rgb[1], *b = voxel.rgb[2];
    bytes[0] = voxel.views;
    std::copy_n(voxel.color_votes.votes.begin(), 3, &bytes[1]);
    std::copy_n(voxel.color_votes.possible.begin(), 3, &bytes[4]);
    ++xyz, ++r, ++g, ++b, ++bytes;
  }
  return cloud;
}

VisualHull hullFromMessage(const sensor_msgs::PointCloud2& cloud, const VoxelGrid& grid) {
  checkFrame(cloud, grid);
  VisualHull hull;
  hull.lattice = latticeFromMessage(grid);
  readVoxels(PointCloudReader(cloud, "hull cloud"), hull);
  sortVoxels(&hull.voxels);
  hull.status = hull.voxels.empty() ? HullStatus::kNobody : HullStatus::kOk;
  if (hull.voxels.empty()) hull.reason = "the hull has no voxels";
  return hull;
}

}  // namespace markerless_mocap
