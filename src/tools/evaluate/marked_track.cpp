#include "tools/evaluate/marked_track.h"

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

#include "evaluation/body_points.h"
#include "evaluation/marked_point.h"
#include "text/joined.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr double kAgrees = 4.0;  // a mark agrees within so many standard deviations

const Camera& cameraNamed(const std::string& name, const CameraRig& rig) {
  std::vector<std::string> names;
  for (const Camera& camera : rig) {
    if (camera.name() == name) return camera;
    names.push_back(camera.name());
  }
  throw std::invalid_argument("the marks are in images of " + name +
                              ", which is not in the rig; it has " + joined(names));
}

std::vector<PointMark> marksOf(const std::string& name,
                               const std::map<std::string, Eigen::Vector2d>& marks, double time_s,
                               const CameraRig& rig) {
  std::vector<PointMark> found;
  for (const auto& [camera_name, pixel] : marks) {
    const Camera& camera = cameraNamed(camera_name, rig);
    if (pixel.minCoeff() < -0.5 || pixel.x() > camera.width() - 0.5 ||
        pixel.y() > camera.height() - 0.5)
      throw std::invalid_argument("the mark " + name + " at " + formatNumber("%.3f", time_s) +
                                  " s is outside the image of " + camera_name + ", " +
                                  std::to_string(camera.width()) + " x " +
                                  std::to_string(camera.height()) + " pixels");
    found.push_back({&camera, pixel});
  }
  return found;
}

/// What is summed over all points.
struct Sums {
  double squares = 0.0;  ///< of the residuals, px^2
  double spread = 0.0;   ///< expected squared errors of the points for marks of 1 px, m^2
  size_t points = 0;
};

/// Why a mark was left out. \param before number of marks of the point \param left those that agree
std::string disagreement(const PointMark& mark, size_t before, const std::vector<PointMark>& left) {
  if (before == 2) return " does not agree with the other camera";
  if (left.empty()) return " agrees with no other camera";
  return " is " + formatNumber("%.0f", residualOf(mark, meetingPoint(left))) +
         " px from the point of the other cameras";
}

void addPoint(const Eigen::Vector3d& point, const std::vector<PointMark>& marks, MarkedTrack* out,
              Sums* sums) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const PointMark& mark : marks) {
    information += informationOf(mark, point);
    const double residual = residualOf(mark, point);
    sums->squares += residual * residual;
    out->residual_max_px = std::fmax(out->residual_max_px, residual);
  }
  sums->spread += information.inverse().trace();
  out->marks += marks.size();
  ++sums->points;
}

}  // namespace

MarkedTrack triangulated(const MarksFile& marks, const CameraRig& rig, int64_t start_ns) {
  MarkedTrack out;
  out.joints.names = bodyPointNames();
  const double limit = kAgrees * marks.sigma_px;
  Sums sums;
  for (const MarkedFrame& frame : marks.frames) {
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Constant(3, long(out.joints.names.size()), NAN);
    for (const auto& [name, in_cameras] : frame.points) {
      std::vector<PointMark> agreeing = marksOf(name, in_cameras, frame.time_s, rig);
      const size_t before = agreeing.size();
      for (const PointMark& mark : leaveOutDisagreeing(limit, &agreeing))
        out.disagreements.push_back(formatNumber("%.3f", frame.time_s) + " s: " + name + " in " +
                                    mark.camera->name() + disagreement(mark, before, agreeing));
      if (agreeing.size() < 2) continue;
      const Eigen::Vector3d point = meetingPoint(agreeing);
      points.col(out.joints.indexOf(name)) = point;
      addPoint(point, agreeing, &out, &sums);
    }
    out.joints.add(start_ns + std::llround(frame.time_s * 1e9), points);
  }
  if (sums.points == 0)
    throw std::invalid_argument("no point is marked in two cameras that agree within " +
                                formatNumber("%.0f", limit) + " px (four sigma_px)");
  out.residual_rms_px = std::sqrt(sums.squares / double(out.marks));
  // Two numbers per mark, three unknowns per point: residuals are smaller than errors.
  const double degrees = std::max(1.0, 2.0 * double(out.marks) - 3.0 * double(sums.points));
  const double sigma = std::max(marks.sigma_px, std::sqrt(sums.squares / degrees));
  out.sigma_mm = 1e3 * sigma * std::sqrt(sums.spread / double(sums.points));
  return out;
}

}  // namespace markerless_mocap
