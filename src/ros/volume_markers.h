#pragma once

#include <visualization_msgs/InteractiveMarker.h>

#include <Eigen/Geometry>
#include <string>

namespace markerless_mocap {

/// Names of the handles of a volume: its lowest and its highest corner.
constexpr const char* kLowCorner = "volume_min";
constexpr const char* kHighCorner = "volume_max";

/// A corner that can be dragged along the three axes. That of the lowest one shows the edges of the
/// box, too. Both have a menu.
/// \param box m in the frame
visualization_msgs::InteractiveMarker cornerMarker(const std::string& name,
                                                   const Eigen::AlignedBox3d& box,
                                                   const std::string& frame);

}  // namespace markerless_mocap
