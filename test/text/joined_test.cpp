#include "text/joined.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

TEST(Joined, WordsStandBetweenCommas) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"one"}), "one");
  EXPECT_EQ(joined({"one", "two"}), "one, two");
}

TEST(Joined, ItemsStandAsTheirTexts) {
  const std::vector<int> items{1, 22};
  EXPECT_EQ(joined(items, [](int item) { return std::to_string(item); }), "1, 22");
}

}  // namespace
}  // namespace markerless_mocap
