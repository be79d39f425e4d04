#include "text/printable.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

TEST(Printable, ControlCharactersAreReplacedAndTheTextIsBounded) {
  EXPECT_EQ(printable("a.yaml: 'x' holds \x1b[2J\x01\x7f, allowed are numbers\nand text"),
            "a.yaml: 'x' holds ?[2J??, allowed are numbers\nand text");
  EXPECT_EQ(printable(std::string(3000, 'a')), std::string(2000, 'a') + " ...");
}

TEST(Printable, ALineHasNoNewLine) {
  EXPECT_EQ(printableLine("one\ntwo\r"), "one two?");
}

TEST(Printable, AWordOfOthersIsQuotedAndShort) {
  EXPECT_EQ(quoted("bgr8"), "\"bgr8\"");
  EXPECT_EQ(quoted("a\nb"), "\"a b\"");
  EXPECT_EQ(quoted(std::string(100000, 'q')), '"' + std::string(80, 'q') + " ...\"");
}

}  // namespace
}  // namespace markerless_mocap
