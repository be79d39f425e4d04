#pragma once

#include <deque>
#include <stdexcept>

#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

/// The last grids of visual_hull. It sends a new one when volume or pitch change, and hulls of the
/// old one may still be on their way.
class HullGrids {
 public:
  void add(const VoxelGridConstPtr& grid) {
    grids_.push_back(grid);
    if (grids_.size() > kKept) grids_.pop_front();
  }
  bool empty() const { return grids_.empty(); }
  /// The grid of a hull: the newest that is not later than the hull. Where all are later, as when a
  /// bag begins again, the newest. Throws std::invalid_argument if there is none.
  const VoxelGridConstPtr& of(const ros::Time& hull_stamp) const {
    if (grids_.empty()) throw std::invalid_argument("no hull/grid has been received yet");
    for (auto grid = grids_.rbegin(); grid != grids_.rend(); ++grid)
      if ((*grid)->header.stamp <= hull_stamp) return *grid;
    return grids_.back();
  }

 private:
  static constexpr size_t kKept = 16;  // a volume may be dragged several times in a second
  std::deque<VoxelGridConstPtr> grids_;
};

}  // namespace markerless_mocap
