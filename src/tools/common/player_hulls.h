#pragma once

#include <cstdint>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"
#include "tools/common/every_nth.h"
#include "tools/common/page.h"

namespace markerless_mocap {

/// Hulls of some frames for a page: the surface of each in voxels of at least 3 cm, one bit per
/// voxel of the box around it.
class PlayerHulls {
 public:
  bool wants(size_t frame) const { return hulls_.wants(frame); }
  /// Hulls without voxels are kept, too: they show that there was none.
  void add(size_t frame, const VisualHull& hull);
  /// [{"frame", "pitch", "corner": [x, y, z], "size": [x, y, z], "bits": base64}]; x runs fastest,
  /// the lowest bit of a byte comes first. Metres, in the world.
  Json json() const;

 private:
  struct Box {
    double pitch = 0.03;
    Eigen::Vector3d corner = Eigen::Vector3d::Zero();
    Eigen::Vector3i size = Eigen::Vector3i::Zero();
    std::vector<uint8_t> bits;
  };
  static Box boxOf(const VisualHull& hull);

  EveryNth<Box> hulls_{kMaxBytes};
  static constexpr size_t kMaxBytes = 2'000'000;
};

}  // namespace markerless_mocap
