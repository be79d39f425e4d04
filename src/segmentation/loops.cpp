#include "segmentation/loops.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace markerless_mocap {
namespace {

// Ways from the tip, in cube roots of the hull's volume: at both the hull must lie on two sides.
constexpr std::array<double, 2> kRings{0.3, 0.4};
constexpr double kWidth = 0.12;      // of a ring
constexpr size_t kLeast = 6;         // nodes of a side
constexpr double kBalance = 0.2;     // of the larger side
constexpr double kThickest = 0.011;  // share of the hull's nodes in a ring around an arm
constexpr double kMost = 3.0;        // such sides in a ring

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

/// Nodes that can be reached from one of them over 26 neighbours, all from `near` to `far` of the
/// tip; those that are found are marked. Ends early where it finds `wanted`.
std::vector<uint32_t> flood(const VoxelGraph& voxels, const std::vector<double>& way,
                            uint32_t start, uint32_t wanted, double near, double far,
                            std::vector<char>* marked) {
  std::vector<uint32_t> found{start};
  (*marked)[start] = 1;
  for (size_t next = 0; next < found.size() && found[next] != wanted; ++next) {
    for (int step = 0; step < 27; ++step) {
      const int32_t node =
          voxels.grid.neighbor(found[next], step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
      if (node < 0 || (*marked)[node] || way[node] < near || way[node] >= far) continue;
      (*marked)[node] = 1;
      found.push_back(uint32_t(node));
    }
  }
  return found;
}

/// The components of a ring's nodes, the largest first.
std::vector<std::vector<uint32_t>> sidesOf(const VoxelGraph& voxels, const std::vector<double>& way,
                                           const std::vector<uint32_t>& nodes, double ring) {
  std::vector<std::vector<uint32_t>> sides;
  std::vector<char> marked(way.size(), 0);
  for (const uint32_t node : nodes)
    if (!marked[node])
      sides.push_back(flood(voxels, way, node, kNone, ring, ring + kWidth, &marked));
  std::sort(sides.begin(), sides.end(),
            [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return sides;
}

bool liesOnTwoSides(const VoxelGraph& voxels, const std::vector<double>& way, double ring) {
  std::vector<uint32_t> nodes;
  for (uint32_t node = 0; node < way.size(); ++node)
    if (way[node] >= ring && way[node] < ring + kWidth) nodes.push_back(node);
  const double thickest = kThickest * double(way.size());
  if (double(nodes.size()) > kMost * thickest) return false;
  const auto sides = sidesOf(voxels, way, nodes, ring);
  if (sides.size() < 2) return false;
  const size_t more = sides[0].size(), fewer = sides[1].size();
  if (fewer < kLeast || double(fewer) < kBalance * double(more) || double(more) > thickest)
    return false;
  std::vector<char> marked(way.size(), 0);
  const uint32_t other = sides[1].front();
  flood(voxels, way, sides[0].front(), other, ring, std::numeric_limits<double>::infinity(),
        &marked);
  return marked[other] != 0;
}

}  // namespace

bool closesLoop(const VoxelGraph& voxels, const std::vector<double>& way) {
  return std::all_of(kRings.begin(), kRings.end(),
                     [&](double ring) { return liesOnTwoSides(voxels, way, ring); });
}

}  // namespace markerless_mocap
