#include "skeleton/thinning/bit_volume.h"

#include <gtest/gtest.h>

#include "skeleton/thin_figures.h"
#include "skeleton/thinning/bit_volume_components.h"
#include "skeleton/thinning/bit_volume_window.h"
#include "skeleton/thinning/cavity_filling.h"
#include "skeleton/thinning/word_set.h"

namespace markerless_mocap {
namespace {

ThinVolume randomVolume(std::mt19937* random, int nx, int ny, int nz, uint32_t percent) {
  ThinVolume volume(nx, ny, nz);
  return volume.fillWhere([&](int, int, int) { return (*random)() % 100 < percent; });
}

TEST(BitVolumeWindowTest, RowsLieAlongTheAxisOfFewestWords) {
  BitVolumeWindow window;
  BitWords bits;
  ThinVolume tall(20, 30, 120);
  tall.fillWhere([](int, int, int) { return true; });
  window.load(tall.lattice, tall.voxels(), &bits);
  EXPECT_EQ(window.box().nx, 120);
  EXPECT_EQ(window.box().row, 2u);
  ThinVolume flat(20, 62, 10);
  flat.fillWhere([](int, int, int) { return true; });
  window.load(flat.lattice, flat.voxels(), &bits);
  EXPECT_EQ(window.box().nx, 62);
  EXPECT_EQ(window.box().row, 1u);
}

TEST(BitVolumeWindowTest, VoxelsComeBackAndNeighborhoodsAreTheirs) {
  std::mt19937 random(1);
  for (const Eigen::Vector3i& size : {Eigen::Vector3i(9, 70, 8), {8, 9, 130}, {66, 5, 7}}) {
    const ThinVolume volume = randomVolume(&random, size.x(), size.y(), size.z(), 40);
    BitVolumeWindow window;
    BitWords bits;
    window.load(volume.lattice, volume.voxels(), &bits);
    EXPECT_EQ(window.unload(volume.lattice, bits), volume.voxels());
    const int axis = window.box().nx == size.x() ? 0 : window.box().nx == size.y() ? 1 : 2;
    for (uint32_t index : volume.voxels()) {
      const Eigen::Vector3i p = volume.lattice.coordinates(index);
      uint32_t around = 0;
      for (int k = 0; k < 27; ++k) {
        Eigen::Vector3i q = p;
        q[axis] += k % 3 - 1;
        q[(axis + 1) % 3] += k / 3 % 3 - 1;
        q[(axis + 2) % 3] += k / 9 - 1;
        around |= uint32_t(volume.at(q.x(), q.y(), q.z())) << k;
      }
      const size_t bit = window.box().bitOf(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]);
      ASSERT_EQ(neighborhood(window.box(), bits.data(), bit), around);
    }
  }
}

TEST(LargestComponentTest, AgreesWithFlooding) {
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    const ThinVolume volume = randomVolume(&random, 3 + i % 70, 6, 5, 2 + random() % 12);
    if (volume.voxels().empty()) continue;
    BitVolumeWindow window;
    BitWords bits;
    window.load(volume.lattice, volume.voxels(), &bits);
    const DroppedComponents dropped = LargestComponent().keep(window.box(), &bits);
    const std::vector<uint32_t> kept = window.unload(volume.lattice, bits);
    ASSERT_EQ(kept.size(), volume.largestComponents().front().voxels().size());
    ASSERT_EQ(ThinVolume(volume.lattice, kept).components(), 1);
    ASSERT_EQ(dropped.components, uint32_t(volume.components() - 1));
    ASSERT_EQ(dropped.voxels, volume.voxels().size() - kept.size());
  }
}

TEST(CavityFillerTest, AgreesWithFlooding) {
  std::mt19937 random(3);
  uint32_t all = 0;
  for (int i = 0; i < 300; ++i) {
    const ThinVolume volume = randomVolume(&random, 4 + i % 70, 8, 7, 60 + random() % 38);
    BitVolumeWindow window;
    BitWords bits;
    window.load(volume.lattice, volume.voxels(), &bits);
    const uint32_t filled = CavityFiller().fill(window.box(), &bits);
    ASSERT_EQ(window.unload(volume.lattice, bits), volume.filled().voxels());
    ASSERT_EQ(filled, volume.filled().voxels().size() - volume.voxels().size());
    all += filled;
  }
  EXPECT_GT(all, 1000u);
}

TEST(CavityFillerTest, WindingWayOutIsNoCavity) {
  ThinVolume block(9, 9, 9);
  block.fillWhere([](int, int, int) { return true; });
  for (int x = 2; x < 8; ++x) block.set(x, 4, 4, false);
  for (int z = 4; z < 8; ++z) block.set(7, 4, z, false);
  for (int y = 4; y < 9; ++y) block.set(7, y, 7, false);
  BitVolumeWindow window;
  BitWords bits;
  window.load(block.lattice, block.voxels(), &bits);
  EXPECT_EQ(CavityFiller().fill(window.box(), &bits), 0u);
}

TEST(WordSetTest, SpansHoldTheSetInFours) {
  WordSet set(300), before(300);
  for (size_t word : {size_t(5), size_t(63), size_t(130), size_t(131), size_t(132)}) set.add(word);
  set.remove(131);
  WordSpans spans;
  set.list(&spans);
  EXPECT_EQ(spans, (WordSpans{{4, 8}, {60, 64}, {128, 136}}));
  before.addBefore(set, 61);
  before.list(&spans);
  EXPECT_EQ(spans, (WordSpans{{0, 4}, {68, 72}}));
}

}  // namespace
}  // namespace markerless_mocap
