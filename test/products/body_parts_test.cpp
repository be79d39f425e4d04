#include "markerless_mocap/products/body_parts.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

TEST(UnseenParts, AreNamedWithTheirSides) {
  std::array<bool, kPartCount> seen;
  seen.fill(true);
  EXPECT_EQ(unseenParts(seen), "");
  seen[size_t(PartLabel::kArm1)] = seen[size_t(PartLabel::kLeg2)] = false;
  EXPECT_EQ(unseenParts(seen), "left arm, right leg not seen");
}

}  // namespace
}  // namespace markerless_mocap
