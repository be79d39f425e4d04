#include "skeleton/thinning/simple_point.h"

#include <gtest/gtest.h>

#include "skeleton/thin_figures.h"

namespace markerless_mocap {
namespace {

TEST(SimplePointTest, AsManyAsAreKnown) {
  EXPECT_EQ(SimplePointTable::shared().count(), 25985144u);
}

TEST(SimplePointTest, AgreesWithCountingOnRandomNeighborhoods) {
  std::mt19937 random(1);
  int simple = 0;
  for (int i = 0; i < 20000; ++i) {
    const uint32_t density = 5 + random() % 90;
    ThinVolume block(3, 3, 3);
    uint32_t around = 0;
    block.fillWhere([&](int x, int y, int z) {
      const bool is = random() % 100 < density;
      around |= uint32_t(is) << (9 * z + 3 * y + x);
      return is;
    });
    block.set(1, 1, 1, false);
    ASSERT_EQ(objectComponents(around), block.components());
    const int components = block.components(), cavities = block.cavities(), euler = block.euler();
    block.set(1, 1, 1);
    const bool same =
        block.components() == components && block.cavities() == cavities && block.euler() == euler;
    ASSERT_EQ(SimplePointTable::shared()(around), same) << around;
    simple += same;
  }
  EXPECT_GT(simple, 2000);
}

}  // namespace
}  // namespace markerless_mocap
