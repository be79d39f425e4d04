#include "tools/calibrate_rig/calibration_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "tools/common/html_text.h"
#include "tools/common/svg_plot.h"

namespace markerless_mocap {
namespace {

constexpr double kDegrees = 180 / M_PI;
const char* const kColors[] = {"#1f5fa8", "#c0392b", "#2a9d5c", "#e0a020",
                               "#7d3c98", "#17a2b8", "#8d6e63", "#555555"};

template <class... Args>
std::string text(const char* format, Args... args) {
  char buffer[600];
  std::snprintf(buffer, sizeof buffer, format, args...);
  return buffer;
}

std::string cell(const std::string& content, bool number = true) {
  return std::string(number ? "<td class=\"n\">" : "<td>") + content + "</td>";
}

std::string lensOf(const CalibratedCamera& camera) {
  std::string tried;
  for (const LensTry& one : camera.lens_trials)
    tried += (tried.empty() ? "" : "; ") + text("%s: %.3f", nameOf(one.lens).c_str(), one.rms);
  return "<span title=\"pixels on views left out: " + escapeHtml(tried) + "\">" +
         nameOf(camera.lens) + "</span>";
}

std::string cameraRow(const CalibratedCamera& c) {
  const Eigen::Matrix3d& K = c.calibration.K;
  return "<tr>" + cell(escapeHtml(c.calibration.name), false) + cell(text("%zu", c.views.size())) +
         cell(text("%.0f %%", 100 * c.coverage)) + cell(text("%.2f", c.rms)) +
         cell(lensOf(c), false) + cell(text("%.1f &plusmn; %.1f", K(0, 0), c.focal_sigma.x())) +
         cell(text("%.1f, %.1f &plusmn; %.1f", K(0, 2), K(1, 2), c.centre_sigma.maxCoeff())) +
         cell(text("&plusmn; %.1f", 1e3 * c.position_sigma.norm())) +
         cell(text("&plusmn; %.3f", kDegrees * c.direction_sigma.norm())) +
         cell(text("%.1f &plusmn; %.1f", 1e3 * c.time_offset, 1e3 * c.time_sigma)) + "</tr>\n";
}

std::string cameraTable(const RigCalibration& result) {
  std::string table =
      "<h2>Cameras</h2><table><tr><th>camera</th><th class=\"n\">views</th><th class=\"n\">image "
      "covered</th><th class=\"n\">residual, px</th><th>lens</th><th class=\"n\">focal, px</th><th "
      "class=\"n\">centre, px</th><th class=\"n\">place, mm</th><th class=\"n\">direction, "
      "&deg;</th><th class=\"n\">time offset, ms</th></tr>\n";
  for (const CalibratedCamera& camera : result.cameras) table += cameraRow(camera);
  return table +
         "</table>\n<p>Uncertainties are one standard deviation; of place and direction, relative "
         "to "
         "all cameras together. The lens model is the simplest one that predicts views that it was "
         "not estimated from as well as the best one does (point at it to see what each "
         "reached).</p>\n";
}

std::string residualsOverTime(const RigCalibration& result) {
  std::set<double> times;
  for (const CalibratedCamera& camera : result.cameras)
    for (const ViewError& view : camera.views) times.insert(view.instant);
  const std::vector<double> all(times.begin(), times.end());
  std::vector<double> seconds;
  for (const double time : all) seconds.push_back(time - all.front());
  std::vector<PlotSeries> lines;
  for (size_t i = 0; i < result.cameras.size(); ++i) {
    const CalibratedCamera& camera = result.cameras[i];
    PlotSeries line{camera.calibration.name, kColors[i % 8], std::vector<double>(all.size(), NAN)};
    for (const ViewError& view : camera.views) {
      const auto at = std::lower_bound(all.begin(), all.end(), view.instant);
      line.values[size_t(at - all.begin())] = view.rms;
    }
    lines.push_back(line);
  }
  return "<h2>Residuals of each view</h2><p>Root mean square of a view's corners, pixels. A camera "
         "that moved steps up.</p>\n" +
         plotLegend(lines) + linePlot(seconds, lines, 0.0, "px");
}

/// Where corners were seen and by how much they are off, 20 times as long.
std::string residualsOverImage(const CalibratedCamera& camera) {
  constexpr double kLonger = 20;
  constexpr size_t kMost = 1500;
  const int width = camera.calibration.width, height = camera.calibration.height;
  size_t corners = 0;
  for (const ViewError& view : camera.views) corners += view.corners.size();
  const size_t every = 1 + corners / kMost;
  std::string used, left_out;
  size_t number = 0;
  for (const ViewError& view : camera.views)
    for (const CornerError& corner : view.corners) {
      if (number++ % every != 0 || !corner.residual.allFinite()) continue;
      const Eigen::Vector2d end = kLonger * corner.residual;
      (corner.used ? used : left_out) +=
          text("M%.0f %.0fl%.0f %.0f", corner.pixel.x(), corner.pixel.y(), end.x(), end.y());
    }
  const double stroke = width / 500.0;
  return text("<figure><svg style=\"background:#f4f4f4\" viewBox=\"0 0 %d %d\">", width, height) +
         text(
             "<path stroke=\"#1f5fa8\" fill=\"none\" stroke-linecap=\"round\" "
             "stroke-width=\"%.2f\" d=\"",
             stroke) +
         used +
         text(
             "\"/><path stroke=\"#c0392b\" fill=\"none\" stroke-linecap=\"round\" "
             "stroke-width=\"%.2f\" d=\"",
             stroke) +
         left_out + "\"/></svg><figcaption>" + escapeHtml(camera.calibration.name) +
         "</figcaption></figure>\n";
}

std::string imageSection(const RigCalibration& result) {
  std::string html =
      "<h2>Residuals over the image</h2><p>A line at each corner, 20 times as long as its "
      "residual; "
      "red: left out. Lines that all point the same way in one part of the image say that the lens "
      "model does not fit there; empty parts were never shown the board.</p>\n<div "
      "class=\"views\">";
  for (const CalibratedCamera& camera : result.cameras) html += residualsOverImage(camera);
  return html + "</div>\n";
}

std::string pairTable(const RigCalibration& result) {
  if (result.cameras.size() < 2) return "";
  std::string table =
      "<h2>Seen together</h2><p>Instants in which both cameras saw the board. Cameras without any "
      "are joined over others.</p><table><tr><th></th>";
  for (const CalibratedCamera& camera : result.cameras)
    table += "<th class=\"n\">" + escapeHtml(camera.calibration.name) + "</th>";
  table += "</tr>\n";
  for (size_t a = 0; a < result.cameras.size(); ++a) {
    table += "<tr>" + cell(escapeHtml(result.cameras[a].calibration.name), false);
    for (size_t b = 0; b < result.cameras.size(); ++b) {
      int shared = 0;
      for (const SharedViews& pair : result.pairs)
        if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)) shared = pair.shared;
      table += cell(a == b ? "" : std::to_string(shared));
    }
    table += "</tr>\n";
  }
  return table + "</table>\n";
}

}  // namespace

std::string calibrationPage(const RigCalibration& result) {
  std::string body;
  for (size_t i = 0; i < result.verdict.size(); ++i)
    body += (i == 0 ? "<p><b>" : "<p>") + escapeHtml(result.verdict[i]) + (i == 0 ? "</b>" : "") +
            "</p>\n";
  body += text("<p>%d places of the board; %d corners left out as outliers.</p>\n", result.instants,
               result.outliers);
  body +=
      cameraTable(result) + residualsOverTime(result) + imageSection(result) + pairTable(result);
  return htmlPage("Calibration of the cameras", body);
}

}  // namespace markerless_mocap
