#include "tools/offline/report_page.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/svg_reader.h"

namespace markerless_mocap {
namespace {

ReportContent sample() {
  ReportContent content;
  content.title = "a <b> & c";
  content.rows = {{1600000000500000000, PoseStatus::kTracked, "", 0.5, 0.05},
                  {1600000000600000000, PoseStatus::kLost, "nobody", NAN, NAN}};
  content.rows[0].part_seen = {true, true, false, true, true, true};
  content.rows[0].part_sigma_m = {0.01, 0.02, 0.123, 0.03, 0.03, 0.03};
  const cv::Mat picture = cv::Mat::zeros(8, 8, CV_8UC3);
  content.cameras = {{"cam0", "learned from <x>", picture, 0.125, {0.5, 0.25}, {0.625, NAN}},
                     {"cam1", "none", cv::Mat(), 0.0, {NAN, NAN}, {NAN, NAN}}};
  content.pictures = {{"first", picture, {picture, picture}}};
  return content;
}

TEST(ReportPage, SaysWhenAndWhyAPoseIsLost) {
  const std::string page = reportPage(sample());
  EXPECT_NE(page.find("2 frame sets: 1 tracked, 0 reinitialized, 1 lost"), std::string::npos);
  EXPECT_NE(page.find("1600000000.600 s: lost nobody"), std::string::npos);
}

TEST(ReportPage, TitleCannotBreakThePage) {
  EXPECT_NE(reportPage(sample()).find("<h1>a &lt;b> &amp; c</h1>"), std::string::npos);
}

TEST(ReportPage, RemarksComeFirst) {
  ReportContent content = sample();
  content.remarks = {"cam0 is turned", "x < y"};
  const std::string page = reportPage(content);
  const size_t first = page.find("<p>cam0 is turned</p>\n<p>x &lt; y</p>");
  EXPECT_NE(first, std::string::npos);
  EXPECT_LT(first, page.find("2 frame sets"));
}

/// The SVG after a heading.
std::string plotUnder(const std::string& page, const std::string& heading) {
  const size_t begin = page.find("<svg", page.find("<h2>" + heading + "</h2>"));
  return page.substr(begin, page.find("</svg>", begin) - begin);
}

/// The only curve of a plot.
Strokes curveOf(const std::string& svg) {
  for (const std::string& path : tagsOf(svg, "path"))
    if (attributeOf(path, "fill") == "none") return dataOf(svg, attributeOf(path, "stroke"));
  return {};
}

TEST(ReportPage, CurvesShowTheFiguresAndStopWhereThereIsNone) {
  const std::string page = reportPage(sample());
  const Strokes overlap = curveOf(plotUnder(page, "Overlap of body and masks"));
  const Strokes error = curveOf(plotUnder(page, "Skeleton error"));
  for (const Strokes& curve : {overlap, error}) {
    ASSERT_EQ(curve.size(), 1u);
    ASSERT_EQ(curve[0].size(), 1u) << "the second instant has no figure";
    EXPECT_NEAR(curve[0][0].x(), 0.0, 0.001);
  }
  EXPECT_NEAR(overlap[0][0].y(), 0.5, 0.001);
  EXPECT_NEAR(error[0][0].y(), 50.0, 0.1) << "in mm";
}

TEST(ReportPage, TheStatusBandHasACellForEachInstant) {
  const std::vector<SvgRect> cells = rectsOf(plotUnder(reportPage(sample()), "Status"));
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_NE(cells[0].title.find("tracked"), std::string::npos);
  EXPECT_NE(cells[1].title.find("lost nobody"), std::string::npos);
}

TEST(ReportPage, CameraWithoutOverlapHasAnEmptyCell) {
  const std::string page = reportPage(sample());
  EXPECT_NE(page.find("<td>cam0</td><td>0.625</td>"), std::string::npos);
  EXPECT_NE(page.find("<td>cam1</td><td></td>"), std::string::npos);
}

TEST(ReportPage, EachPartHasABandThatTellsWhenItWasNotSeen) {
  const std::vector<SvgRect> cells =
      rectsOf(plotUnder(reportPage(sample()), "Parts of the body that were not seen"));
  ASSERT_EQ(cells.size(), 12u) << "six parts, two instants";
  for (size_t part = 0; part < 6; ++part) {
    EXPECT_EQ(cells[2 * part].title,
              std::string(part == 2 ? "not seen" : "seen") + ", 0.00 s to 0.10 s");
    EXPECT_EQ(cells[2 * part + 1].title, "no pose: nobody, 0.10 s to 0.20 s");
    EXPECT_EQ(cells[2 * part].y, cells[2 * part + 1].y);
  }
  EXPECT_GT(cells[2].y, cells[0].y + cells[0].height);
}

TEST(ReportPage, TellsHowOftenPartsWereNotSeenAndWhy) {
  const std::string page = reportPage(sample());
  const std::string n = "<td class=\"n\">", end = "</td>";
  EXPECT_NE(page.find("<td>l_arm</td>" + n + "0" + end + n + "1" + end + n + "1" + end + n + end +
                      n + "12.3" + end),
            std::string::npos);
  EXPECT_NE(page.find("<td>r_arm</td>" + n + "1" + end + n + "0" + end + n + "1" + end + n + "3.0" +
                      end + n + end),
            std::string::npos);
  EXPECT_NE(page.find(n + "1" + end + "<td>no pose: nobody</td>"), std::string::npos);
  EXPECT_NE(page.find(n + "1" + end + "<td>not all parts seen: no message</td>"),
            std::string::npos);
}

TEST(ReportPage, ReasonsThatDifferInNumbersCountTogether) {
  ReportContent content = sample();
  content.rows[0] = content.rows[1];
  content.rows[0].reason = "overlap 0.41";
  content.rows[1].reason = "overlap 0.38";
  EXPECT_NE(reportPage(content).find("<td class=\"n\">2</td><td>no pose: overlap 0.41</td>"),
            std::string::npos);
}

/// What the page says of a camera.
std::string sectionOf(const std::string& page, const std::string& camera) {
  const size_t begin = page.find("<h3>" + camera + "</h3>");
  return begin == std::string::npos ? "" : page.substr(begin, page.find("<h3>", begin + 1) - begin);
}

int countOf(const std::string& text, const std::string& what) {
  int count = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(ReportPage, EachCameraShowsItsBackgroundAndItsViews) {
  const std::string page = reportPage(sample());
  const std::string first = sectionOf(page, "cam0"), second = sectionOf(page, "cam1");
  EXPECT_NE(first.find("learned from &lt;x>; blue: never seen without the person, 12.5 % of"),
            std::string::npos);
  EXPECT_EQ(countOf(first, "<img"), 2) << "the background and one instant";
  EXPECT_NE(second.find("Background: none</p>"), std::string::npos);
  EXPECT_EQ(countOf(second, "<img"), 1);
}

TEST(ReportPage, EachCameraShowsHowFarItsMasksAreKnown) {
  const std::string first = sectionOf(reportPage(sample()), "cam0");
  EXPECT_NE(first.find("37.5 % is unknown on average"), std::string::npos);
  const Strokes unknown = dataOf(first, "#e0a020"), overlap = dataOf(first, "#1f5fa8");
  ASSERT_EQ(unknown.size(), 1u);
  ASSERT_EQ(unknown[0].size(), 2u);
  EXPECT_NEAR(unknown[0][0].y(), 0.5, 0.001);
  EXPECT_NEAR(unknown[0][1].y(), 0.25, 0.001);
  ASSERT_EQ(overlap.size(), 1u);
  EXPECT_NEAR(overlap[0][0].y(), 0.625, 0.001);
  EXPECT_NE(sectionOf(reportPage(sample()), "cam1").find("This camera gave no mask"),
            std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
