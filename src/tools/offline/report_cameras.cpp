#include "tools/offline/report_cameras.h"

#include <cmath>
#include <cstdio>

#include "tools/common/html_text.h"
#include "tools/common/svg_plot.h"

namespace markerless_mocap {
namespace {

constexpr const char *kUnknownLine = "#e0a020", *kOverlapLine = "#1f5fa8";

std::string percent(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * fraction);
  return text;
}

std::string backgroundPart(const ReportCamera& camera) {
  const std::string source = "Background: " + camera.background_source;
  if (camera.background.empty()) return "<p>" + escapeHtml(source) + "</p>\n";
  const std::string unknown = camera.background_unknown > 0
                                  ? "; blue: never seen without the person, " +
                                        percent(camera.background_unknown) + " of the image"
                                  : "; all of it is known";
  return pictureTag(camera.background, source + unknown);
}

std::string confidencePart(const ReportCamera& camera, const std::vector<double>& seconds) {
  const std::vector<PlotSeries> lines = {
      {"share of the mask that is unknown", kUnknownLine, camera.unknown_of_row},
      {"overlap of body and mask (IoU), where the mask is known", kOverlapLine, camera.iou_of_row}};
  const double unknown = meanOfFinite(camera.unknown_of_row);
  if (std::isnan(unknown)) return "<p>This camera gave no mask.</p>\n";
  return "<p>Of its masks, " + percent(unknown) + " is unknown on average.</p>\n" +
         plotLegend(lines) + linePlot(seconds, lines, 1.0, "");
}

std::string views(const ReportContent& content, size_t camera) {
  std::string html = "<div class=\"views\">\n";
  for (const ReportPicture& picture : content.pictures)
    if (camera < picture.views.size()) html += pictureTag(picture.views[camera], picture.caption);
  return html + "</div>\n";
}

}  // namespace

double meanOfFinite(const std::vector<double>& values) {
  double sum = 0.0;
  int count = 0;
  for (const double value : values)
    if (std::isfinite(value)) {
      sum += value;
      ++count;
    }
  return count == 0 ? NAN : sum / count;
}

std::string cameraSections(const ReportContent& content, const std::vector<double>& seconds) {
  std::string html =
      "<h2>What each camera saw</h2><p>In the views: red outline: what the mask says is the "
      "person; "
      "blue: unknown, the person may be there or not; green outline: the fitted body without the "
      "parts that are not seen. Where red and green run together, the silhouette holds the body. "
      "Inside blue there is no silhouette: there the body follows from the other cameras and, with "
      "colour images, from the person's colours.</p>\n";
  for (size_t i = 0; i < content.cameras.size(); ++i) {
    const ReportCamera& camera = content.cameras[i];
    html += "<h3>" + escapeHtml(camera.name) + "</h3>\n" + backgroundPart(camera) +
            confidencePart(camera, seconds) + views(content, i);
  }
  return html;
}

}  // namespace markerless_mocap
