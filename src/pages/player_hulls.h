#pragma once

#include <cstdint>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"
#include "pages/every_nth.h"
#include "pages/page.h"

namespace markerless_mocap {

/// Hulls of some frames for a page: the surface of each in voxels of at least 3 cm, as the gaps
/// between them in the box around it.
class PlayerHulls {
 public:
  bool wants(size_t frame) const { return hulls_.wants(frame); }
  void halveFrames() { hulls_.halveFrames(); }  ///< see EveryNth
  /// Hulls without voxels are kept, too: they show that there was none.
  void add(size_t frame, const VisualHull& hull);
  /// [{"frame", "pitch", "corner": [x, y, z], "size": [x, y, z], "gaps": base64}]; metres, in the
  /// world. Each byte is the number of cells, x running fastest, before the next one of the
  /// surface; 255: so many, and the next byte counts on.
  Json json() const;

 private:
  struct Box {
    double pitch = 0.03;
    Eigen::Vector3d corner = Eigen::Vector3d::Zero();
    Eigen::Vector3i size = Eigen::Vector3i::Zero();
    std::vector<uint8_t> gaps;
  };
  static Box boxOf(const VisualHull& hull);

  EveryNth<Box> hulls_{kMaxBytes};
  static constexpr size_t kMaxBytes = 2'300'000;
};

}  // namespace markerless_mocap
