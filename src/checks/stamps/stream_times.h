#pragma once

#include <cstdint>
#include <vector>

#include "checks/seen_rig.h"

namespace markerless_mocap {

/// The times of one camera's images.
struct StreamTimes {
  int zero = 0;             ///< stamps that are zero
  int backwards = 0;        ///< stamps before the one before
  int doubled = 0;          ///< stamps equal to the one before
  double worst_back = 0;    ///< s
  double period = 0;        ///< median interval, s; 0: fewer than three stamps
  int missing = 0;          ///< images that gaps leave out
  int longest_gap = 0;      ///< missing images in a row
  double jitter = 0;        ///< standard deviation from even spacing, robust, s
  double delay_spread = 0;  ///< of received - stamp: from the 5th to the 95th percentile, s
  double delay = 0;         ///< median of received - stamp, s
  int64_t first_ns = 0, last_ns = 0;  ///< smallest and largest stamp that is not zero
};

StreamTimes timesOf(const std::vector<SeenImage>& images);

/// Images equal to the one before, while the other cameras' images change.
struct Repeats {
  int images = 0;
  int longest = 0;  ///< in a row
};
Repeats repeatsOf(const std::vector<SeenImage>& images);

}  // namespace markerless_mocap
