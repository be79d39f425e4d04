#include "tools/common/svg_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

int countOf(const std::string& text, const std::string& what) {
  int count = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(niceTickStep(100, 5), 20);
  EXPECT_DOUBLE_EQ(niceTickStep(103, 5), 50);
  EXPECT_DOUBLE_EQ(niceTickStep(0.3, 10), 0.05);
  EXPECT_DOUBLE_EQ(niceTickStep(0, 5), 1);
}

TEST(LinePlot, BreaksWhereThereIsNoValue) {
  const std::string svg = linePlot({0, 1, 2, 3}, {{"", "red", {5, NAN, 5, 10}}}, 10, "mm");
  const size_t at = svg.find("stroke=\"red\" d=\"");
  const std::string path = svg.substr(at, svg.find("\"/>", at) - at);
  EXPECT_EQ(countOf(path, "M"), 2);  // after the gap it begins anew
  EXPECT_EQ(countOf(path, "L"), 1);
  EXPECT_NE(path.find("L679 8"), std::string::npos) << path;  // 3 of 4 s, top of the axis
}

TEST(LinePlot, TopIsRoundAndAboveAllValues) {
  EXPECT_NE(linePlot({0, 1}, {{"", "red", {47, 83}}}, 0, "mm").find(">100 mm<"), std::string::npos);
}

TEST(TimeBand, HasACellForEachFrameWithItsTitle) {
  const std::string svg = timeBand({0, 1}, {{"green", "a<b"}, {"red", "lost"}});
  EXPECT_EQ(countOf(svg, "<rect"), 2);
  EXPECT_NE(svg.find("<title>a&lt;b</title>"), std::string::npos);
}

TEST(BarChart, LeavesOutWhatHasNoFigure) {
  const std::string svg =
      barChart({{"head", {10, NAN}}, {"knee", {NAN, NAN}}}, {"red", "blue"}, "mm");
  EXPECT_EQ(countOf(svg, "<rect"), 1);
  EXPECT_NE(svg.find(">knee<"), std::string::npos);
}

TEST(Histogram, CountsEachFiniteValueOnce) {
  // Bins of 2 up to 10.
  const std::string svg = histogram({1, 1, 3, 10, NAN}, 5, "red", "mm");
  EXPECT_EQ(countOf(svg, "<title>2</title>"), 1);
  EXPECT_EQ(countOf(svg, "<title>1</title>"), 2);
  EXPECT_EQ(countOf(svg, "<title>0</title>"), 2);
  EXPECT_EQ(countOf(histogram({}, 5, "red", "mm"), "<title>0</title>"), 5);
}

}  // namespace
}  // namespace markerless_mocap
