#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace markerless_mocap {

/// Reads the points of a cloud of which nothing is known: its sizes and fields are checked before
/// a byte is read. The cloud must outlive the reader.
class PointCloudReader {
 public:
  /// \param what how sentences name the cloud, for example "hull cloud"
  /// Throws std::invalid_argument if the sizes contradict each other or the bytes are big endian.
  PointCloudReader(const sensor_msgs::PointCloud2& cloud, std::string what);

  size_t size() const { return points_; }

  /// Offset of a field of one number in a point, bytes. Throws std::invalid_argument unless
  /// exactly one field has the name, and it has the type and lies inside the point.
  /// \param type of sensor_msgs::PointField: FLOAT32 or UINT8
  size_t offset(const std::string& name, uint8_t type) const;

  float number(size_t point, size_t offset) const;
  uint8_t byte(size_t point, size_t offset) const { return *at(point, offset); }

 private:
  const uint8_t* at(size_t point, size_t offset) const {
    return cloud_.data.data() + point * cloud_.point_step + offset;
  }

  const sensor_msgs::PointCloud2& cloud_;
  std::string what_;
  size_t points_ = 0;
};

/// The fields x, y and z of all points.
class PointReader {
 public:
  /// Throws std::invalid_argument as PointCloudReader::offset().
  explicit PointReader(const PointCloudReader& cloud);
  /// Metres; may be not finite.
  Eigen::Vector3d operator()(size_t point) const;

 private:
  const PointCloudReader& cloud_;
  size_t x_, y_, z_;
};

}  // namespace markerless_mocap
