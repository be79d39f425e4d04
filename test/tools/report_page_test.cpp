#include "tools/offline/report_page.h"

#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_NE(page.find("2 instants: 1 tracked, 0 reinitialized, 1 lost"), std::string::npos);
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
  EXPECT_LT(first, page.find("2 instants"));
}

TEST(ReportPage, CurvesStopWhereThereIsNoFigure) {
  // Half of the plot's height for the first of two instants, nothing for the second.
  EXPECT_NE(reportPage(sample()).find("d=\"M46 77h0\""), std::string::npos);
}

TEST(ReportPage, CameraWithoutOverlapHasAnEmptyCell) {
  const std::string page = reportPage(sample());
  EXPECT_NE(page.find("<td>cam0</td><td>0.625</td>"), std::string::npos);
  EXPECT_NE(page.find("<td>cam1</td><td></td>"), std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
