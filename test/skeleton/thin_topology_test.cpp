#include <gtest/gtest.h>

#include "skeleton/thin_figures.h"
#include "skeleton/thinner.h"
#include "skeleton/thinning/bit_volume_window.h"
#include "skeleton/thinning/thinning_scheme.h"

namespace markerless_mocap {
namespace {

/// By the definition that needs no neighbourhood tables: nothing is counted differently without the
/// voxel, in the block of its neighbours.
bool simpleByCounting(const ThinVolume& volume, int x, int y, int z) {
  ThinVolume block(3, 3, 3);
  block.fillWhere([&](int i, int j, int k) { return volume.at(x + i - 1, y + j - 1, z + k - 1); });
  block.set(1, 1, 1);
  const int components = block.components(), cavities = block.cavities(), euler = block.euler();
  block.set(1, 1, 1, false);
  return block.components() == components && block.cavities() == cavities && block.euler() == euler;
}

void expectThin(const ThinVolume& thin) {
  for (uint32_t index : thin.voxels()) {
    const Eigen::Vector3i p = thin.lattice.coordinates(index);
    if (thin.neighborCount(p.x(), p.y(), p.z()) == 1) continue;
    EXPECT_FALSE(simpleByCounting(thin, p.x(), p.y(), p.z())) << p.transpose();
  }
}

/// That of the largest components which holds a voxel, its cavities filled.
ThinVolume bodyAround(const ThinVolume& volume, uint32_t voxel) {
  const Eigen::Vector3i p = volume.lattice.coordinates(voxel);
  for (const ThinVolume& component : volume.largestComponents())
    if (component.filled().at(p.x(), p.y(), p.z())) return component.filled();
  return {1, 1, 1};
}

void expectSameTopology(const ThinVolume& volume, double persistence) {
  const CurveSkeleton skeleton = Thinner(persistence).thin(volume.lattice, volume.voxels());
  ASSERT_FALSE(skeleton.voxels.empty());
  const ThinVolume body = bodyAround(volume, skeleton.voxels.front());
  const ThinVolume thin(skeleton.lattice, skeleton.voxels);
  ASSERT_EQ(thin.components(), 1);
  ASSERT_EQ(thin.cavities(), 0);
  ASSERT_EQ(thin.tunnels(), body.tunnels());
  for (uint32_t index : skeleton.voxels) {
    const Eigen::Vector3i p = thin.lattice.coordinates(index);
    ASSERT_TRUE(body.at(p.x(), p.y(), p.z()));
  }
  expectThin(thin);
}

TEST(ThinTopologyTest, RandomVolumes) {
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    const auto size = [&] { return 1 + int(random() % 8); };
    const int nx = size(), ny = size(), nz = size();
    ThinVolume volume(nx, ny, nz);
    const uint32_t density = 10 + random() % 85;
    volume.fillWhere([&](int, int, int) { return random() % 100 < density; });
    if (volume.voxels().empty()) continue;
    expectSameTopology(volume, volume.lattice.pitch * double(i % 4));
    if (HasFailure()) return;
  }
}

TEST(ThinTopologyTest, RandomLimbs) {
  std::mt19937 random(2);
  for (int i = 0; i < 40; ++i) {
    const ThinVolume volume = randomLimbs(&random, 18, 24, 30);
    expectSameTopology(volume, volume.lattice.pitch * double(i % 4));
    if (HasFailure()) return;
  }
}

/// Rows of two words, whichever axis they lie along.
TEST(ThinTopologyTest, LargeRandomVolumes) {
  std::mt19937 random(3);
  for (uint32_t density : {60u, 92u}) {
    ThinVolume volume(66, 63, 64);
    volume.fillWhere([&](int, int, int) { return random() % 100 < density; });
    expectSameTopology(volume, 0.0);
  }
  const ThinVolume limbs = randomLimbs(&random, 70, 63, 64);
  expectSameTopology(limbs, 0.05);
}

struct Thinned {
  ThinVolume volume;
  explicit Thinned(const ThinVolume& before, int persistence) : volume(before) {
    BitVolumeWindow window;
    BitWords bits;
    SymmetricThinning thinning;
    window.load(before.lattice, before.voxels(), &bits);
    thinning.thin(window.box(), persistence, &bits);
    volume = ThinVolume(before.lattice, window.unload(before.lattice, bits));
  }
};

TEST(SymmetricPeelingTest, KeepsComponentsCavitiesAndTunnels) {
  std::mt19937 random(4);
  for (int i = 0; i < 3000; ++i) {
    const auto size = [&] { return 1 + int(random() % 7); };
    const int nx = size(), ny = size(), nz = size();
    ThinVolume volume(nx, ny, nz);
    const uint32_t density = 10 + random() % 85;
    volume.fillWhere([&](int, int, int) { return random() % 100 < density; });
    if (volume.voxels().empty()) continue;
    const Thinned thinned(volume, 1 + i % 3);
    ASSERT_EQ(thinned.volume.components(), volume.components());
    ASSERT_EQ(thinned.volume.cavities(), volume.cavities());
    ASSERT_EQ(thinned.volume.euler(), volume.euler());
  }
}

TEST(SymmetricPeelingTest, MirrorImagesArePeeledToMirrorImages) {
  std::mt19937 random(5);
  for (int i = 0; i < 12; ++i) {
    const ThinVolume volume = randomLimbs(&random, 16, 20, 26);
    if (volume.voxels().empty()) continue;
    const Thinned thinned(volume, 1 + i % 3);
    for (int axis = 0; axis < 3; ++axis) {
      const Thinned other(mirrored(volume, axis), 1 + i % 3);
      ASSERT_EQ(other.volume.voxels(), mirrored(thinned.volume, axis).voxels());
    }
  }
}

}  // namespace
}  // namespace markerless_mocap
