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
  content.cameras = {"cam0", "cam1"};
  content.iou_of_camera = {0.625, NAN};
  content.pictures = {{"first", cv::Mat::zeros(8, 8, CV_8UC3)}};
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

}  // namespace
}  // namespace markerless_mocap
