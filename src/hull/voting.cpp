#include "hull/voting.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr uint32_t kBlock = 16384;

/// Voxels of one block that are still in the race, with what they have collected.
struct Survivors {
  std::vector<uint32_t> voxel;
  std::vector<uint8_t> seen, against;

  Survivors(uint32_t begin, uint32_t end)
      : voxel(end - begin), seen(end - begin), against(end - begin) {
    for (uint32_t i = 0; i < voxel.size(); ++i) voxel[i] = begin + i;
  }

  /// Takes one camera's votes; drops voxels that have more than `missing` against them.
  void vote(const Voter& voter, int missing) {
    const int32_t* pixels = voter.pixel_of_voxel->data();
    const uint8_t* mask = voter.mask.data;
    size_t kept = 0;
    for (size_t i = 0; i < voxel.size(); ++i) {
      const int32_t pixel = pixels[voxel[i]];
      const bool sees = pixel >= 0;
      const uint8_t contra = uint8_t(against[i] + (sees && mask[pixel] == 0));
      voxel[kept] = voxel[i];
      seen[kept] = uint8_t(seen[i] + sees);
      against[kept] = contra;
      kept += contra <= missing;
    }
    voxel.resize(kept);
  }
};

}  // namespace

std::vector<uint32_t> voteForeground(std::vector<Voter> voters, uint32_t voxel_count, int min_views,
                                     int missing_votes_allowed) {
  // Small silhouettes first: they end most voxels early. The result does not depend on the order.
  std::stable_sort(voters.begin(), voters.end(),
                   [](const Voter& a, const Voter& b) { return a.set_pixels < b.set_pixels; });
  std::vector<std::vector<uint32_t>> found((voxel_count + kBlock - 1) / kBlock);
  const auto vote_block = [&](size_t block) {
    const uint32_t begin = uint32_t(block) * kBlock;
    Survivors survivors(begin, std::min(begin + kBlock, voxel_count));
    for (const Voter& voter : voters) survivors.vote(voter, missing_votes_allowed);
    for (size_t i = 0; i < survivors.voxel.size(); ++i)
      if (survivors.seen[i] >= min_views) found[block].push_back(survivors.voxel[i]);
  };
  tbb::parallel_for(size_t(0), found.size(), vote_block);

  std::vector<uint32_t> all;
  for (const std::vector<uint32_t>& block : found)
    all.insert(all.end(), block.begin(), block.end());
  return all;
}

}  // namespace markerless_mocap
