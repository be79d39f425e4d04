#include "tools/evaluate/json_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace markerless_mocap {
namespace {

TEST(JsonText, WritesWhatAParserReads) {
  JsonObject inner, outer;
  inner.add("b", size_t(3));
  outer.add("a", 0.5);
  outer.add("inner", inner);
  outer.addList("list", "1, 2");
  EXPECT_EQ(outer.text(), "{\n \"a\": 0.5,\n \"inner\": {\n  \"b\": 3\n },\n \"list\": [1, 2]\n}");
}

TEST(JsonText, HasNoFigureWhereThereIsNone) {
  EXPECT_EQ(JsonObject::number(NAN), "null");
  EXPECT_EQ(JsonObject::number(INFINITY), "null");
}

TEST(JsonText, QuotesWhatWouldEndAString) {
  EXPECT_EQ(JsonObject::quoted("a\"b\\c\nd"), "\"a\\\"b\\\\c\\u000ad\"");
}

}  // namespace
}  // namespace markerless_mocap
