#pragma once

#include <sensor_msgs/PointCloud2.h>

namespace markerless_mocap {

/// Rounds the size of a point up to whole floats, so that those of each point lie at addresses from
/// which a processor may read floats. To be called between setting the fields and the size.
inline void alignPoints(sensor_msgs::PointCloud2* cloud) {
  constexpr uint32_t kFloat = sizeof(float);
  cloud->point_step = (cloud->point_step + kFloat - 1) / kFloat * kFloat;
}

}  // namespace markerless_mocap
