#include "ros/point_cloud_reader.h"

#include <cstring>
#include <stdexcept>
#include <utility>

namespace markerless_mocap {

using sensor_msgs::PointField;

PointCloudReader::PointCloudReader(const sensor_msgs::PointCloud2& cloud, std::string what)
    : cloud_(cloud), what_(std::move(what)) {
  const uint64_t points = uint64_t(cloud.width) * cloud.height;  // 32 bits each: no overflow
  const size_t step = cloud.point_step, bytes = cloud.data.size();
  // Divided, because points * step may overflow.
  const bool agree =
      step == 0 ? points == 0 && bytes == 0 : bytes % step == 0 && bytes / step == points;
  if (!agree)
    throw std::invalid_argument(what_ + " has " + std::to_string(bytes) + " bytes for " +
                                std::to_string(points) + " points of " + std::to_string(step) +
                                " bytes");
  if (cloud.is_bigendian)
    throw std::invalid_argument(what_ + " is big endian, allowed is little endian");
  points_ = size_t(points);
}

size_t PointCloudReader::offset(const std::string& name, uint8_t type) const {
  const PointField* found = nullptr;
  for (const PointField& field : cloud_.fields) {
    if (field.name != name) continue;
    if (found) throw std::invalid_argument(what_ + " has the field \"" + name + "\" twice");
    found = &field;
  }
  const size_t bytes = type == PointField::UINT8 ? 1 : 4;
  // In 64 bits, because an offset of nearly 2^32 wraps in 32.
  const bool usable = found && found->datatype == type && found->count <= 1 &&
                      uint64_t(found->offset) + bytes <= cloud_.point_step;
  if (!usable)
    throw std::invalid_argument(what_ + " has no field \"" + name + "\" that is one " +
                                (type == PointField::UINT8 ? "uint8" : "float32") +
                                " inside the point");
  return found->offset;
}

float PointCloudReader::number(size_t point, size_t offset) const {
  float value;  // copied, because a point's bytes need not be aligned
  std::memcpy(&value, at(point, offset), sizeof(value));
  return value;
}

PointReader::PointReader(const PointCloudReader& cloud)
    : cloud_(cloud),
      x_(cloud.offset("x", PointField::FLOAT32)),
      y_(cloud.offset("y", PointField::FLOAT32)),
      z_(cloud.offset("z", PointField::FLOAT32)) {}

Eigen::Vector3d PointReader::operator()(size_t point) const {
  return Eigen::Vector3f(cloud_.number(point, x_), cloud_.number(point, y_),
                         cloud_.number(point, z_))
      .cast<double>();
}

}  // namespace markerless_mocap
