#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// Masks of given stamps from a bag, stored in compressed form.
class MaskStore {
 public:
  /// Reads silhouettes.
  /// \param topics one per camera; a missing topic gives no masks
  /// \param stamps_ns ascending; the nearest mask within the tolerance is used
  /// Throws std::runtime_error if the bag cannot be read, std::invalid_argument on an invalid mask.
  MaskStore(const std::string& bag, const std::vector<std::string>& topics,
            const std::vector<int64_t>& stamps_ns, int64_t tolerance_ns);

  bool empty() const { return masks_.empty(); }
  /// CV_8UC1 0 | 128 unknown | 255; empty if missing.
  cv::Mat at(int64_t stamp_ns, size_t camera) const;

 private:
  struct Entry {
    int64_t gap_ns;
    std::vector<uint8_t> png;
  };
  std::map<std::pair<int64_t, size_t>, Entry> masks_;
};

/// The element of `stamps_ns` (ascending) nearest to `stamp_ns` within the tolerance; nullptr if
/// there is none.
const int64_t* nearestStamp(const std::vector<int64_t>& stamps_ns, int64_t stamp_ns,
                            int64_t tolerance_ns);

}  // namespace markerless_mocap
