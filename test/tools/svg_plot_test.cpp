#include "tools/common/svg_plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/svg_reader.h"

namespace markerless_mocap {
namespace {

// Numbers in the SVG have six digits.
constexpr double kPrinted = 0.01;

void expectNear(const Eigen::Vector2d& found, const Eigen::Vector2d& expected) {
  EXPECT_LT((found - expected).norm(), kPrinted) << found.transpose();
}

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(niceTickStep(100, 5), 20);
  EXPECT_DOUBLE_EQ(niceTickStep(103, 5), 50);
  EXPECT_DOUBLE_EQ(niceTickStep(0.3, 10), 0.05);
  EXPECT_DOUBLE_EQ(niceTickStep(0, 5), 1);
}

TEST(LinePlot, ShowsTheValuesAndBreaksWhereThereIsNone) {
  const std::string svg = linePlot({0, 1, 2, 3}, {{"", "red", {5, NAN, 5, 10}}}, 10, "mm");
  const Strokes data = dataOf(svg, "red");
  ASSERT_EQ(data.size(), 2u);
  ASSERT_EQ(data[0].size(), 1u);
  ASSERT_EQ(data[1].size(), 2u);
  expectNear(data[0][0], {0, 5});
  expectNear(data[1][0], {2, 5});
  expectNear(data[1][1], {3, 10});
}

TEST(LinePlot, GreaterValuesAndLaterOnesLieFurtherAlongTheAxes) {
  const std::string svg = linePlot({2, 3, 5}, {{"", "red", {1, 2, 4}}}, 0, "mm");
  const Strokes strokes = strokesOf(svg, "red");
  ASSERT_EQ(strokes.size(), 1u);
  ASSERT_EQ(strokes[0].size(), 3u);
  for (size_t i = 1; i < 3; ++i) {
    EXPECT_GT(strokes[0][i].x(), strokes[0][i - 1].x());
    EXPECT_LT(strokes[0][i].y(), strokes[0][i - 1].y()) << "y of SVG points down";
  }
  const Strokes data = dataOf(svg, "red");
  expectNear(data[0][0], {2, 1});
  expectNear(data[0][2], {5, 4});
}

TEST(LinePlot, ValuesBeyondTheTopEndThere) {
  const Strokes data = dataOf(linePlot({0, 1}, {{"", "red", {5, 70}}}, 10, "mm"), "red");
  ASSERT_EQ(data.size(), 1u);
  expectNear(data[0][1], {1, 10});
}

TEST(LinePlot, TopIsRoundAndAboveAllValues) {
  const std::string svg = linePlot({0, 1}, {{"", "red", {47, 83}}}, 0, "mm");
  EXPECT_EQ(axisOf(svg, true).last_value, 100);
  EXPECT_NE(svg.find("100 mm<"), std::string::npos) << "the last label has the unit";
  const Strokes data = dataOf(svg, "red");
  ASSERT_EQ(data.size(), 1u);
  expectNear(data[0][0], {0, 47});
  expectNear(data[0][1], {1, 83});
}

TEST(TimeBand, HasACellForEachFrameWithItsTitle) {
  const std::string svg = timeBand({0, 1, 3}, {{"green", "a<b"}, {"red", "lost"}, {"green", "c"}});
  const std::vector<SvgRect> cells = rectsOf(svg);
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells[0].title, "a&lt;b");
  EXPECT_EQ(cells[1].title, "lost");
  EXPECT_EQ(attributeOf(tagsOf(svg, "rect")[1], "fill"), "red");
  // A cell lasts until the next frame; a little overlap hides the seam.
  for (size_t i = 1; i < 3; ++i) EXPECT_NEAR(cells[i - 1].x + cells[i - 1].width, cells[i].x, 0.5);
  EXPECT_NEAR(cells[1].width, 2 * cells[0].width, 0.5);
}

TEST(TimeBand, HasTheTimeAxisOfLinePlots) {
  const std::vector<double> seconds{0, 1, 2, 3};
  const std::vector<SvgRect> cells =
      rectsOf(timeBand(seconds, std::vector<BandCell>(4, {"red", ""})));
  const Strokes line = strokesOf(linePlot(seconds, {{"", "red", {1, 1, 1, 1}}}, 0, "mm"), "red");
  ASSERT_EQ(cells.size(), 4u);
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(cells[i].x, line.at(0).at(i).x(), kPrinted);
}

TEST(BarChart, BarsAreAsLongAsTheirFiguresAndLeaveOutWhatHasNone) {
  const std::string svg = barChart({{"head", {10, NAN}}, {"knee", {NAN, NAN}}, {"foot", {5, 20}}},
                                   {"red", "blue"}, "mm");
  const std::vector<SvgRect> bars = rectsOf(svg);
  ASSERT_EQ(bars.size(), 3u);
  const ReadAxis axis = axisOf(svg, false);
  const double expected[] = {10, 5, 20};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(axis.valueAt(bars[i].x), 0, kPrinted);
    EXPECT_NEAR(axis.valueAt(bars[i].x + bars[i].width), expected[i], kPrinted);
    EXPECT_EQ(std::stod(bars[i].title), expected[i]);
  }
  EXPECT_LT(bars[0].y + bars[0].height, bars[1].y);
  for (const char* name : {"head", "knee", "foot"})
    EXPECT_NE(svg.find(">" + std::string(name) + "<"), std::string::npos);
}

TEST(Histogram, CountsEachFiniteValueOnce) {
  const std::string svg = histogram({1, 1, 3, 10, NAN}, 5, "red", "mm");
  const std::vector<SvgRect> bins = rectsOf(svg);  // of 2 up to 10
  ASSERT_EQ(bins.size(), 5u);
  const double expected[] = {2, 1, 0, 0, 1};
  const ReadAxis axis = axisOf(svg, true);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(std::stod(bins[i].title), expected[i]) << i;
    EXPECT_NEAR(axis.valueAt(bins[i].y), expected[i], kPrinted) << i;
    EXPECT_NEAR(axis.valueAt(bins[i].y + bins[i].height), 0, kPrinted) << i;
    if (i > 0) {
      EXPECT_GT(bins[i].x, bins[i - 1].x);
    }
  }
  for (const SvgRect& bin : rectsOf(histogram({}, 5, "red", "mm"))) EXPECT_EQ(bin.title, "0");
}

}  // namespace
}  // namespace markerless_mocap
