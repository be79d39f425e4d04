#include "pages/player_hulls.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kMinPitch = 0.03;  // metres
constexpr uint8_t kLongGap = 255;

/// Occupied cells of a box.
struct Cells {
  Eigen::Vector3i size;
  std::vector<bool> inside;

  size_t at(const Eigen::Vector3i& cell) const {
    return (size_t(cell.z()) * size_t(size.y()) + size_t(cell.y())) * size_t(size.x()) +
           size_t(cell.x());
  }
  bool holds(const Eigen::Vector3i& cell) const {
    return (cell.array() >= 0).all() && (cell.array() < size.array()).all() && inside[at(cell)];
  }
  bool isSurface(const Eigen::Vector3i& cell) const {
    if (!holds(cell)) return false;
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1})
        if (!holds(cell + step * Eigen::Vector3i::Unit(axis))) return true;
    return false;
  }
};

std::vector<uint8_t> surfaceGaps(const Cells& cells) {
  std::vector<uint8_t> gaps;
  size_t next = 0;  // cell after the last one of the surface
  Eigen::Vector3i cell;
  for (cell.z() = 0; cell.z() < cells.size.z(); ++cell.z())
    for (cell.y() = 0; cell.y() < cells.size.y(); ++cell.y())
      for (cell.x() = 0; cell.x() < cells.size.x(); ++cell.x()) {
        if (!cells.isSurface(cell)) continue;
        const size_t at = cells.at(cell);
        for (; at - next >= kLongGap; next += kLongGap) gaps.push_back(kLongGap);
        gaps.push_back(uint8_t(at - next));
        next = at + 1;
      }
  return gaps;
}

}  // namespace

PlayerHulls::Box PlayerHulls::boxOf(const VisualHull& hull) {
  const VoxelLattice& lattice = hull.lattice;
  Box box;
  if (hull.voxels.empty()) return box;
  const int joined = std::max(1, int(std::ceil(kMinPitch / lattice.pitch - 1e-6)));
  const auto cellOf = [&](const HullVoxel& voxel) -> Eigen::Vector3i {
    return lattice.coordinates(voxel.index) / joined;
  };
  Eigen::Vector3i low = cellOf(hull.voxels.front()), high = low;
  for (const HullVoxel& voxel : hull.voxels) {
    low = low.cwiseMin(cellOf(voxel));
    high = high.cwiseMax(cellOf(voxel));
  }
  Cells cells{high - low + Eigen::Vector3i::Ones(), {}};
  cells.inside.assign(size_t(cells.size.prod()), false);
  for (const HullVoxel& voxel : hull.voxels) cells.inside[cells.at(cellOf(voxel) - low)] = true;
  box.pitch = joined * lattice.pitch;
  box.corner = lattice.origin + box.pitch * low.cast<double>();
  box.size = cells.size;
  box.gaps = surfaceGaps(cells);
  return box;
}

void PlayerHulls::add(size_t frame, const VisualHull& hull) {
  Box box = boxOf(hull);
  const size_t bytes = box.gaps.size();
  hulls_.add(frame, std::move(box), bytes);
}

Json PlayerHulls::json() const {
  Json out = Json::array();
  for (const auto& [frame, hull] : hulls_.items()) {
    const Box& box = hull.first;
    out.push_back({{"frame", frame},
                   {"pitch", box.pitch},
                   {"corner", {box.corner.x(), box.corner.y(), box.corner.z()}},
                   {"size", {box.size.x(), box.size.y(), box.size.z()}},
                   {"gaps", base64(box.gaps.data(), box.gaps.size())}});
  }
  return out;
}

}  // namespace markerless_mocap
