#pragma once

#include <cstdint>
#include <vector>

#include "region/colors/color_bins.h"

namespace markerless_mocap {

/// Probability of each bin of colour. Empty until something has been learned.
class ColorHistogram {
 public:
  bool empty() const { return probability_.empty(); }
  const float* data() const { return probability_.data(); }
  /// Learns from counted colours. \param counts by bin \param rate weight of the new counts, 0 to
  /// 1;
  ///   the first counts are taken over. Nothing happens if there are too few.
  void learn(const std::vector<uint32_t>& counts, float rate);

 private:
  std::vector<float> probability_;
};

}  // namespace markerless_mocap
