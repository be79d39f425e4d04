#include "numerics/face_parts.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

using Places = std::vector<size_t>;

TEST(FaceParts, TheLargestIsKeptInItsOrder) {
  EXPECT_EQ(largestFacePart({{5, 5, 5}, {0, 1, 0}, {0, 0, 0}, {5, 5, 7}, {0, 1, 1}}),
            (Places{1, 2, 4}));
  EXPECT_EQ(largestFacePart({}), Places());
}

TEST(FaceParts, EdgesAndCornersDoNotJoin) {
  EXPECT_EQ(largestFacePart({{0, 0, 0}, {1, 1, 0}, {2, 2, 1}}), Places{0});
}

TEST(FaceParts, TheEndOfARowDoesNotTouchTheNextRow) {
  EXPECT_EQ(largestFacePart({{9, 0, 0}, {0, 1, 0}, {1, 1, 0}}), (Places{1, 2}));
}

}  // namespace
}  // namespace markerless_mocap
