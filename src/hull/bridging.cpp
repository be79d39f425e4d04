#include "hull/bridging.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace markerless_mocap {
namespace {

constexpr double kLongestBridge = 0.5;  // m
/// A bridge is as thick as ways longer than the shortest by this make it, m.
constexpr double kDetour = 0.12;
constexpr int16_t kOutside = -2, kUnreached = -1;

using Voxels = std::vector<uint32_t>;

/// Steps over 26-neighbours within `loose` from the nearest voxel of `from`, at most `most`.
std::vector<int16_t> stepsFrom(const VoxelLattice& lattice, const Voxels& loose, const Voxels& from,
                               int most) {
  std::vector<int16_t> steps(lattice.count(), kOutside);
  for (const uint32_t voxel : loose) steps[voxel] = kUnreached;
  for (const uint32_t voxel : from) steps[voxel] = 0;
  Voxels front = from, next;
  for (int step = 1; step <= most && !front.empty(); ++step, front.swap(next), next.clear())
    for (const uint32_t voxel : front) {
      const Eigen::Vector3i at = lattice.coordinates(voxel);
      const Eigen::Vector3i low = (at.array() - 1).max(0);
      const Eigen::Vector3i high = (at.array() + 1).min(lattice.size.array() - 1);
      for (int k = low.z(); k <= high.z(); ++k)
        for (int j = low.y(); j <= high.y(); ++j)
          for (int i = low.x(); i <= high.x(); ++i) {
            int16_t& there = steps[lattice.index(i, j, k)];
            if (there != kUnreached) continue;
            there = int16_t(step);
            next.push_back(lattice.index(i, j, k));
          }
    }
  return steps;
}

/// Both pieces and the bridge between them; empty if there is none.
Voxels joined(const VoxelLattice& lattice, const Voxels& loose, const Voxels& body,
              const Voxels& piece) {
  const int most = int(std::lround((kLongestBridge + kDetour) / lattice.pitch));
  const std::vector<int16_t> from_body = stepsFrom(lattice, loose, body, most);
  const std::vector<int16_t> from_piece = stepsFrom(lattice, loose, piece, most);
  int shortest = most + 1;
  for (const uint32_t voxel : piece)
    if (from_body[voxel] >= 0) shortest = std::min<int>(shortest, from_body[voxel]);
  if (shortest * lattice.pitch > kLongestBridge) return {};
  const int longest = shortest + int(std::lround(kDetour / lattice.pitch));
  Voxels both;
  for (const uint32_t voxel : loose) {
    const int a = from_body[voxel], b = from_piece[voxel];
    if (a == 0 || b == 0 || (a > 0 && b > 0 && a + b <= longest)) both.push_back(voxel);
  }
  return both;
}

}  // namespace

std::vector<Voxels> bridgePieces(const VoxelLattice& lattice, const Voxels& loose,
                                 std::vector<Voxels> pieces, size_t least_voxels) {
  std::vector<Voxels> result;
  for (Voxels& piece : pieces) {
    Voxels both;
    if (!result.empty() && piece.size() >= least_voxels)
      both = joined(lattice, loose, result[0], piece);
    if (both.empty())
      result.push_back(std::move(piece));
    else
      result[0] = std::move(both);
  }
  return result;
}

}  // namespace markerless_mocap
