#include "pages/page.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pages/every_nth.h"
#include "pages/page_reader.h"

namespace markerless_mocap {
namespace {

TEST(Page, IsOneFileThatLoadsNothing) {
  Page page("t");
  page.add({{"kind", "player"}});
  const std::string html = page.html();
  for (const char* loads : {"src=\"", "<link", "@import", "url("})
    EXPECT_EQ(html.find(loads), std::string::npos) << loads;
  EXPECT_NE(html.find("THREE"), std::string::npos);
  EXPECT_LT(Page("t").html().size(), 100000u) << "a page without a player needs no 3D library";
}

TEST(Page, TextsCannotEndTheScriptTheyStandIn) {
  Page page("a </script><script>alert(1)</script> b");
  page.text("<!--<script>");
  page.text("caf\xe9 is no UTF-8");
  const std::string html = page.html();
  EXPECT_EQ(html.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(html.find("<!--<script>"), std::string::npos);
  const Json content = contentOf(html);
  EXPECT_EQ(content["title"], "a </script><script>alert(1)</script> b");
  EXPECT_EQ(content["parts"][0]["text"], "<!--<script>");
  EXPECT_EQ(content["parts"][1]["text"], "caf\xef\xbf\xbd is no UTF-8");
}

TEST(Page, KeepsThePartsInTheirOrderAndTheNumbersAsTheyAre) {
  Page page("t");
  page.heading("first");
  page.lines({0, 0.5}, "s", {{"a", {1.25, NAN}}}, "mm");
  page.bars({"x"}, {{"row", {NAN}}}, "mm");
  const Json content = contentOf(page.html());
  ASSERT_EQ(content["parts"].size(), 3u);
  const Json lines = partUnder(content, "first", "lines");
  EXPECT_EQ(floatsOf(lines["x"]), (std::vector<float>{0, 0.5}));
  const std::vector<float> values = floatsOf(lines["lines"][0]["values"]);
  EXPECT_EQ(values.at(0), 1.25f);
  EXPECT_TRUE(std::isnan(values.at(1)));
  EXPECT_TRUE(partUnder(content, "first", "bars")["rows"][0]["values"][0].is_null());
}

TEST(Page, EqualCellsAreOneRun) {
  const Json runs = joinedCells({{0, ""}, {0, ""}, {1, "a"}, {1, "b"}, {1, "b"}});
  EXPECT_EQ(runs, Json::parse(R"([[0,2,0,""],[2,3,1,"a"],[3,5,1,"b"]])"));
}

TEST(Page, BytesComeBackFromBase64) {
  for (const std::string text : {"", "a", "ab", "abc", "\xff\x01\x02\x03"})
    EXPECT_EQ(unpacked<char>(base64(text.data(), text.size())),
              std::vector<char>(text.begin(), text.end()));
}

TEST(EveryNth, ForgetsEverySecondItemWhenTheyOutgrowTheLimit) {
  EveryNth<int> items(30);
  for (size_t frame = 0; frame < 100; ++frame)
    if (items.wants(frame)) items.add(frame, int(frame), 10);
  // Three of 10 fit: every 64th frame is the first that stays below.
  std::vector<size_t> frames;
  for (const auto& [frame, item] : items.items()) frames.push_back(frame);
  EXPECT_EQ(frames, (std::vector<size_t>{0, 64}));
  EveryNth<int> few(30);
  for (size_t frame = 0; frame < 3; ++frame) few.add(frame, 0, 10);
  EXPECT_EQ(few.items().size(), 3u) << "what fits stays";
}

TEST(EveryNth, HalvedFramesAreNumberedAnew) {
  EveryNth<int> items(50);
  for (size_t frame = 0; frame < 5; ++frame) items.add(frame, int(frame), 10);
  items.halveFrames();
  std::vector<std::pair<size_t, int>> kept;
  for (const auto& [frame, item] : items.items()) kept.emplace_back(frame, item.first);
  EXPECT_EQ(kept, (std::vector<std::pair<size_t, int>>{{0, 0}, {1, 2}, {2, 4}}));
  EXPECT_TRUE(items.wants(3)) << "nothing was left out before";
}

}  // namespace
}  // namespace markerless_mocap
