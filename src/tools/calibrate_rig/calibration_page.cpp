#include "tools/calibrate_rig/calibration_page.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "pages/page.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr double kDegrees = 180 / M_PI;

std::string plusMinus(const std::string& value, const char* format, double sigma) {
  return value + (value.empty() ? "± " : " ± ") + formatNumber(format, sigma);
}

std::string counted(int count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string triedLenses(const CalibratedCamera& camera) {
  std::string tried;
  for (const LensTrial& one : camera.lens_trials)
    tried += (tried.empty() ? "" : "; ") + nameOf(one.lens) + formatNumber(": %.3f", one.rms);
  return tried;
}

/// \param middle of all cameras' time offsets, s
std::vector<std::string> cameraRow(const CalibratedCamera& c, double middle) {
  const Eigen::Matrix3d& K = c.calibration.K;
  const std::string centre = formatNumber("%.1f, ", K(0, 2)) + formatNumber("%.1f", K(1, 2));
  return {
      c.calibration.name,
      std::to_string(c.views.size()),
      formatNumber("%.0f %%", 100 * c.coverage),
      formatNumber("%.2f", c.rms),
      nameOf(c.lens),
      plusMinus(formatNumber("%.1f", K(0, 0)), "%.1f", c.focal_sigma.x()),
      plusMinus(centre, "%.1f", c.centre_sigma.maxCoeff()),
      plusMinus("", "%.1f", 1e3 * c.position_sigma.norm()),
      plusMinus("", "%.3f", kDegrees * c.direction_sigma.norm()),
      plusMinus(formatNumber("%.1f", 1e3 * (c.time_offset - middle)), "%.1f", 1e3 * c.time_sigma)};
}

void addCameras(const RigCalibration& result, Page* page) {
  std::vector<std::vector<std::string>> cameras, lenses;
  for (const CalibratedCamera& camera : result.cameras) {
    cameras.push_back(cameraRow(camera, middleOffset(result)));
    if (!camera.lens_trials.empty())
      lenses.push_back({camera.calibration.name, triedLenses(camera)});
  }
  page->heading("Cameras");
  page->table({"camera", "#views", "#image covered", "#residual, px", "lens", "#focal, px",
               "#centre, px", "#place, mm", "#direction, °", "#time offset, ms"},
              cameras);
  page->text(
      "Uncertainties are one standard deviation; of place and direction, relative to all cameras "
      "together.");
  if (lenses.empty()) return;  // they were given
  page->text(
      "The lens model is the simplest one that predicts views that it was not estimated from as "
      "well "
      "as the best one does:");
  page->table({"camera", "pixels on views left out, by lens model"}, lenses);
}

void addResidualsOverTime(const RigCalibration& result, Page* page) {
  std::set<double> times;
  for (const CalibratedCamera& camera : result.cameras)
    for (const ViewError& view : camera.views) times.insert(view.instant);
  const std::vector<double> all(times.begin(), times.end());
  if (all.size() < 2) return;
  std::vector<double> seconds;
  for (const double time : all) seconds.push_back(time - all.front());
  std::vector<PlotLine> lines;
  for (const CalibratedCamera& camera : result.cameras) {
    PlotLine line{camera.calibration.name, std::vector<double>(all.size(), NAN)};
    for (const ViewError& view : camera.views) {
      const auto at = std::lower_bound(all.begin(), all.end(), view.instant);
      line.values[size_t(at - all.begin())] = view.rms;
    }
    lines.push_back(line);
  }
  page->heading("Residuals of each view");
  page->text("Root mean square of a view's corners, pixels. A camera that moved steps up.");
  page->lines(seconds, "s", lines, "px");
}

/// Where corners were seen and by how much they are off.
Json residualsOverImage(const CalibratedCamera& camera) {
  constexpr size_t kMost = 1500;
  size_t corners = 0;
  for (const ViewError& view : camera.views) corners += view.corners.size();
  const size_t every = 1 + corners / kMost;
  std::vector<double> used, left_out;
  size_t number = 0;
  for (const ViewError& view : camera.views)
    for (const CornerError& corner : view.corners) {
      if (number++ % every != 0 || !corner.residual.allFinite()) continue;
      std::vector<double>& out = corner.used ? used : left_out;
      out.insert(out.end(),
                 {corner.pixel.x(), corner.pixel.y(), corner.residual.x(), corner.residual.y()});
    }
  return {{"name", camera.calibration.name},
          {"size", {camera.calibration.width, camera.calibration.height}},
          {"used", packed(used)},
          {"left_out", packed(left_out)}};
}

void addResidualsOverImage(const RigCalibration& result, Page* page) {
  page->heading("Residuals over the image");
  page->text(
      "A line at each corner, 20 times as long as its residual; red: left out. Lines that all "
      "point the same way in one part of the image say that the lens model does not fit there; "
      "empty parts were never shown the board.");
  Json cameras = Json::array();
  for (const CalibratedCamera& camera : result.cameras)
    cameras.push_back(residualsOverImage(camera));
  page->add({{"kind", "residuals"}, {"longer", 20}, {"cameras", cameras}});
}

int sharedViews(const RigCalibration& result, size_t a, size_t b) {
  for (const SharedViews& pair : result.pairs)
    if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)) return pair.shared;
  return 0;
}

void addPairs(const RigCalibration& result, Page* page) {
  if (result.cameras.size() < 2) return;
  std::vector<std::string> head{""};
  std::vector<std::vector<std::string>> rows;
  for (size_t a = 0; a < result.cameras.size(); ++a) {
    head.push_back("#" + result.cameras[a].calibration.name);
    rows.push_back({result.cameras[a].calibration.name});
    for (size_t b = 0; b < result.cameras.size(); ++b)
      rows.back().push_back(a == b ? "" : std::to_string(sharedViews(result, a, b)));
  }
  page->heading("Seen together");
  page->text(
      "Instants in which both cameras saw the board. Cameras without any are joined over others.");
  page->table(head, rows);
}

}  // namespace

std::string calibrationPage(const RigCalibration& result) {
  Page page("Calibration of the cameras");
  for (size_t i = 0; i < result.verdict.size(); ++i) page.text(result.verdict[i], i == 0);
  page.text(counted(result.instants, "place", "places") + " of the board; " +
            counted(result.outliers, "corner", "corners") + " left out as outliers.");
  addCameras(result, &page);
  addResidualsOverTime(result, &page);
  addResidualsOverImage(result, &page);
  addPairs(result, &page);
  return page.html();
}

}  // namespace markerless_mocap
