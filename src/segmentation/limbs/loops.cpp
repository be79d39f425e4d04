#include "segmentation/limbs/loops.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace markerless_mocap {
namespace {

// Distances from the extremity, in cube roots of the hull's volume; at both of them the hull must
// have two sides.
constexpr std::array<double, 2> kRings{0.3, 0.4};
constexpr double kWidth = 0.12;   // of a ring
constexpr size_t kMinSide = 6;    // minimum number of nodes of a side
constexpr double kBalance = 0.2;  // minimum size of the smaller side relative to the larger
/// Maximum fraction of the hull's nodes in a ring around an arm.
constexpr double kMaxThickness = 0.011;
constexpr double kMaxRing = 3.0;  // maximum size of a ring, in such sides

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
constexpr double kEverywhere = std::numeric_limits<double>::infinity();

/// The components of a ring's nodes, the largest first.
std::vector<std::vector<uint32_t>> sidesOf(const std::vector<uint32_t>& nodes,
                                           NodeGrid::Region* region) {
  std::vector<std::vector<uint32_t>> sides;
  region->put(nodes);
  for (const uint32_t node : nodes)
    if (region->has(node)) sides.push_back(region->takeConnected(node, kNone));
  std::sort(sides.begin(), sides.end(),
            [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return sides;
}

std::vector<uint32_t> nodesFrom(const std::vector<double>& geodesic, double near, double far) {
  std::vector<uint32_t> nodes;
  for (uint32_t node = 0; node < geodesic.size(); ++node)
    if (geodesic[node] >= near && geodesic[node] < far) nodes.push_back(node);
  return nodes;
}

bool liesOnTwoSides(const std::vector<double>& geodesic, double ring, NodeGrid::Region* region) {
  const std::vector<uint32_t> nodes = nodesFrom(geodesic, ring, ring + kWidth);
  const double thickest = kMaxThickness * double(geodesic.size());
  if (double(nodes.size()) > kMaxRing * thickest) return false;
  const auto sides = sidesOf(nodes, region);
  if (sides.size() < 2) return false;
  const size_t more = sides[0].size(), fewer = sides[1].size();
  if (fewer < kMinSide || double(fewer) < kBalance * double(more) || double(more) > thickest)
    return false;
  const std::vector<uint32_t> beyond = nodesFrom(geodesic, ring, kEverywhere);
  region->put(beyond);
  const uint32_t other = sides[1].front();
  region->takeConnected(sides[0].front(), other);
  const bool meet = !region->has(other);
  region->remove(beyond);
  return meet;
}

}  // namespace

bool closesLoop(const std::vector<double>& geodesic, NodeGrid::Region* region) {
  return std::all_of(kRings.begin(), kRings.end(),
                     [&](double ring) { return liesOnTwoSides(geodesic, ring, region); });
}

}  // namespace markerless_mocap
