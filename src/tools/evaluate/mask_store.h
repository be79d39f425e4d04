#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// Masks of chosen instants from a bag, kept compressed.
class MaskStore {
 public:
  /// Reads silhouettes.
  /// \param topics one per camera; a topic that the bag lacks gives no masks
  /// \param stamps_ns instants, ascending; the nearest mask within the tolerance is taken
  /// Throws std::runtime_error if the bag cannot be read, std::invalid_argument if a mask is none.
  MaskStore(const std::string& bag, const std::vector<std::string>& topics,
            const std::vector<int64_t>& stamps_ns, int64_t tolerance_ns);

  bool empty() const { return masks_.empty(); }
  /// CV_8UC1 0 | 255; an empty mat where there is none.
  cv::Mat at(int64_t stamp_ns, size_t camera) const;

 private:
  struct Entry {
    int64_t gap_ns;
    std::vector<uint8_t> png;
  };
  std::map<std::pair<int64_t, size_t>, Entry> masks_;
};

/// The one of `stamps_ns` (ascending) nearest to `stamp_ns` within the tolerance; nullptr if none.
const int64_t* nearestStamp(const std::vector<int64_t>& stamps_ns, int64_t stamp_ns,
                            int64_t tolerance_ns);

}  // namespace markerless_mocap
