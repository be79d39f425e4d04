#pragma once

#include <algorithm>
#include <deque>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "markerless_mocap/ros/messages.h"
#include "ros/hull_conversions.h"

namespace markerless_mocap {

/// The last grids of visual_hull. It sends a new one when volume or pitch change, and hulls of the
/// old one may still be on their way.
class HullGrids {
 public:
  /// Returns why the grid cannot be used, and is not kept; empty if it is.
  std::string add(const VoxelGridConstPtr& grid) {
    try {
      latticeFromMessage(*grid);
    } catch (const std::exception& error) {
      return std::string("hull/grid has sent what cannot be used: ") + error.what();
    }
    const auto same = [&](const VoxelGridConstPtr& other) { return isSame(*other, *grid); };
    grids_.erase(std::remove_if(grids_.begin(), grids_.end(), same), grids_.end());
    grids_.push_back(grid);
    if (grids_.size() > kKept) grids_.pop_front();
    return "";
  }
  bool empty() const { return grids_.empty(); }
  /// The hull on the newest grid that is not later than it. Where it does not lie on that one, as
  /// when a bag begins again or another node has sent a grid, on the newest that it lies on. Throws
  /// std::invalid_argument if there is no grid, or as hullFromMessage() on the first one tried.
  VisualHull hullOf(const sensor_msgs::PointCloud2& cloud) const {
    if (grids_.empty()) throw std::invalid_argument("no hull/grid has been received yet");
    std::optional<std::string> fault;
    for (const VoxelGridConstPtr& grid : inOrder(cloud.header.stamp)) {
      try {
        return hullFromMessage(cloud, *grid);
      } catch (const std::exception& error) {
        if (!fault) fault = error.what();
      }
    }
    throw std::invalid_argument(*fault);
  }

 private:
  static constexpr size_t kKept = 16;  // a volume may be dragged several times in a second

  static bool isSame(const VoxelGrid& a, const VoxelGrid& b) {
    return a.header.frame_id == b.header.frame_id && a.origin == b.origin && a.pitch == b.pitch &&
           a.size == b.size;
  }
  std::vector<VoxelGridConstPtr> inOrder(const ros::Time& stamp) const {
    std::vector<VoxelGridConstPtr> order(grids_.rbegin(), grids_.rend());
    std::stable_partition(order.begin(), order.end(), [&](const VoxelGridConstPtr& grid) {
      return grid->header.stamp <= stamp;
    });
    return order;
  }

  std::deque<VoxelGridConstPtr> grids_;
};

}  // namespace markerless_mocap
