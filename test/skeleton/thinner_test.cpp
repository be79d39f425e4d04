#include "markerless_mocap/skeleton/thinner.h"

#include <gtest/gtest.h>

#include <random>

#include "skeleton/thin_volume.h"

namespace markerless_mocap {
namespace {

TEST(ThinnerTest, RandomVolumesKeepComponentsAndTunnels) {
  std::mt19937 random(1);
  Thinner thinner;
  for (int i = 0; i < 4000; ++i) {
    const auto size = [&] { return 1 + int(random() % 8); };
    ThinVolume volume(size(), size(), size());
    const uint32_t density = 10 + random() % 81;
    volume.fillWhere([&](int, int, int) { return random() % 100 < density; });
    const CurveSkeleton skeleton = thinner.thin(volume.lattice, volume.voxels());
    ThinVolume thin(skeleton.lattice, skeleton.voxels);
    if (volume.voxels().empty()) continue;
    ASSERT_EQ(thin.components(), 1);
    ASSERT_EQ(thin.cavities(), 0);
    ASSERT_EQ(skeleton.components_dropped, uint32_t(volume.components() - 1));
    if (skeleton.components_dropped == 0) {
      ASSERT_EQ(thin.tunnels(), volume.tunnels()) << i;
    }
  }
}

}  // namespace
}  // namespace markerless_mocap
