#include "tools/offline/report_page.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "tools/common/html_text.h"
#include "tools/common/svg_plot.h"
#include "tools/offline/report_cameras.h"
#include "tools/offline/report_limbs.h"

namespace markerless_mocap {
namespace {

constexpr const char* kLineColor = "#1f5fa8";

const char* colorOf(PoseStatus status) {
  switch (status) {
    case PoseStatus::kTracked:
      return "#2a9d5c";
    case PoseStatus::kReinitialized:
      return "#e0a020";
    case PoseStatus::kLost:
      break;
  }
  return "#c0392b";
}

std::string seconds(int64_t stamp_ns) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << stamp_ns * 1e-9 << " s";
  return text.str();
}

std::vector<double> secondsOf(const std::vector<ReportRow>& rows) {
  std::vector<double> seconds;
  for (const ReportRow& row : rows)
    seconds.push_back(double(row.stamp_ns - rows.front().stamp_ns) * 1e-9);
  return seconds;
}

std::string statusBand(const std::vector<ReportRow>& rows) {
  std::vector<BandCell> cells;
  for (const ReportRow& row : rows)
    cells.push_back({colorOf(row.status),
                     seconds(row.stamp_ns) + ": " + toString(row.status) + ' ' + row.reason});
  return timeBand(secondsOf(rows), cells);
}

template <class Figure>
std::string plot(const std::vector<ReportRow>& rows, double top, const std::string& unit,
                 const Figure& figure) {
  PlotSeries line{"", kLineColor, {}};
  for (const ReportRow& row : rows) line.values.push_back(figure(row));
  return linePlot(secondsOf(rows), {line}, top, unit);
}

std::string counts(const std::vector<ReportRow>& rows) {
  std::ostringstream text;
  const auto count = [&](PoseStatus status) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const ReportRow& row) { return row.status == status; });
  };
  text << rows.size() << " frame sets: " << count(PoseStatus::kTracked) << " tracked, "
       << count(PoseStatus::kReinitialized) << " reinitialized, " << count(PoseStatus::kLost)
       << " lost";
  return text.str();
}

std::string cameraTable(const ReportContent& content) {
  std::ostringstream table;
  table << "<table><tr><th>camera</th><th>mean IoU</th></tr>" << std::fixed << std::setprecision(3);
  for (const ReportCamera& camera : content.cameras) {
    const double mean_iou = meanOfFinite(camera.iou_of_row);
    table << "<tr><td>" << escapeHtml(camera.name) << "</td><td>";
    if (std::isfinite(mean_iou)) table << mean_iou;
    table << "</td></tr>";
  }
  table << "</table>\n";
  return table.str();
}

}  // namespace

std::string reportPage(const ReportContent& content) {
  std::string body;
  for (const std::string& remark : content.remarks) body += "<p>" + escapeHtml(remark) + "</p>\n";
  body += "<p>" + counts(content.rows) + "</p>\n";
  body += "<h2>Status</h2><p>green tracked, amber reinitialized, red lost</p>\n" +
          statusBand(content.rows);
  body += "<h2>Overlap of body and masks</h2><p>mean intersection over union of the views</p>\n" +
          plot(content.rows, 1.0, "", [](const ReportRow& row) { return row.mean_iou; });
  body += "<h2>Skeleton error</h2><p>mean distance of part curves to the body, mm</p>\n" +
          plot(content.rows, 200.0, "mm",
               [](const ReportRow& row) { return 1e3 * row.skeleton_error_m; });
  body += limbSection(content.rows, secondsOf(content.rows));
  body += cameraTable(content) + "<h2>Pictures</h2><p>filled: body; outline: mask</p>\n";
  for (const ReportPicture& picture : content.pictures)
    body += pictureTag(picture.image, picture.caption);
  body += cameraSections(content, secondsOf(content.rows));
  return htmlPage(content.title, body);
}

}  // namespace markerless_mocap
