#include "ros/hull_conversions.h"

#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

using sensor_msgs::PointField;
constexpr const char* kAxisNames[3] = {"x", "y", "z"};
constexpr const char* kByteFields[7] = {"views",      "votes_x",    "votes_y",   "votes_z",
                                        "possible_x", "possible_y", "possible_z"};

void checkField(const sensor_msgs::PointCloud2& cloud, const std::string& name, uint8_t type,
                uint32_t bytes) {
  for (const PointField& field : cloud.fields) {
    const bool fits = field.offset + bytes <= cloud.point_step;
    if (field.name == name && field.datatype == type && fits) return;
  }
  throw std::invalid_argument("hull cloud has no field \"" + name +
                              "\" of the type in hull/points");
}

void checkCloud(const sensor_msgs::PointCloud2& cloud, const VoxelGrid& grid) {
  if (cloud.header.frame_id != grid.header.frame_id)
    throw std::invalid_argument("hull cloud is in the frame \"" + cloud.header.frame_id +
                                "\", allowed is the grid's \"" + grid.header.frame_id + "\"");
  const size_t points = size_t(cloud.width) * cloud.height;
  if (cloud.data.size() != points * cloud.point_step)
    throw std::invalid_argument("hull cloud has " + std::to_string(cloud.data.size()) +
                                " bytes for " + std::to_string(points) + " points of " +
                                std::to_string(cloud.point_step) + " bytes");
  for (const char* name : kAxisNames) checkField(cloud, name, PointField::FLOAT32, 4);
  checkField(cloud, "rgb", PointField::FLOAT32, 4);
  for (const char* name : kByteFields) checkField(cloud, name, PointField::UINT8, 1);
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

void readVoxels(const sensor_msgs::PointCloud2& cloud, VisualHull& hull) {
  using Bytes = sensor_msgs::PointCloud2ConstIterator<uint8_t>;
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x"), y(cloud, "y"), z(cloud, "z");
  Bytes r(cloud, "r"), g(cloud, "g"), b(cloud, "b");
  std::vector<Bytes> bytes;
  for (const char* name : kByteFields) bytes.emplace_back(cloud, name);
  hull.voxels.resize(size_t(cloud.width) * cloud.height);
  for (HullVoxel& voxel : hull.voxels) {
    voxel.index = voxelAt(hull.lattice, Eigen::Vector3d(*x, *y, *z));
    voxel.rgb = {*r, *g, *b};
    voxel.views = *bytes[0];
    for (size_t axis = 0; axis < 3; ++axis) {
      voxel.color_votes.votes[axis] = *bytes[1 + axis];
      voxel.color_votes.possible[axis] = *bytes[4 + axis];
    }
    ++x, ++y, ++z, ++r, ++g, ++b;
    for (Bytes& byte : bytes) ++byte;
  }
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
  VoxelLattice lattice;
  lattice.origin = {grid.origin.x, grid.origin.y, grid.origin.z};
  lattice.pitch = grid.pitch;
  for (int axis = 0; axis < 3; ++axis) lattice.size[axis] = static_cast<int>(grid.size[axis]);
  const bool usable = lattice.origin.allFinite() && std::isfinite(lattice.pitch) &&
                      lattice.pitch > 0.0 && lattice.size.minCoeff() > 0;
  if (!usable)
    throw std::invalid_argument(
        "voxel grid is unusable, allowed are a finite origin, a positive pitch and sizes of 1 or "
        "more");
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
  checkCloud(cloud, grid);
  VisualHull hull;
  hull.lattice = latticeFromMessage(grid);
  readVoxels(cloud, hull);
  std::sort(hull.voxels.begin(), hull.voxels.end(),
            [](const HullVoxel& a, const HullVoxel& b) { return a.index < b.index; });
  hull.status = hull.voxels.empty() ? HullStatus::kNobody : HullStatus::kOk;
  if (hull.voxels.empty()) hull.reason = "the hull has no voxels";
  return hull;
}

}  // namespace markerless_mocap
