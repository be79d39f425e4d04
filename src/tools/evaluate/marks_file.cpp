#include "tools/evaluate/marks_file.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "evaluation/body_points.h"
#include "files/text_file.h"
#include "files/yaml_map.h"
#include "files/yaml_text.h"
#include "text/joined.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr double kAgrees = 4.0;  // a mark agrees within so many standard deviations

void addCamera(const std::string& camera, YamlMap* marks, MarkedFrame* frame) {
  for (const std::string& name : bodyPointNames()) {
    if (!marks->optional(name)) continue;
    const std::vector<double> pixel = marks->numbers(name, 2, "[u, v] in pixels");
    frame->points[name][camera] = {pixel[0], pixel[1]};
  }
  marks->finish();
}

MarkedFrame frameOf(const YAML::Node& node, const std::string& where) {
  YamlMap map(node, where);
  MarkedFrame frame;
  frame.time_s = map.number("time");
  YamlMap cameras = map.map("marks");
  for (const std::string& name : cameras.keys()) {
    YamlMap marks = cameras.map(name);
    addCamera(name, &marks, &frame);
  }
  map.finish();
  return frame;
}

MarksFile marksOf(const YAML::Node& root, const std::string& path) {
  YamlMap map(root, path);
  MarksFile marks;
  if (map.optional("start")) marks.start_s = map.number("start");
  if (map.optional("sigma_px")) marks.sigma_px = map.number("sigma_px");
  if (marks.sigma_px <= 0.0) map.fail("sigma_px is not above 0");
  const YAML::Node frames = map.optional("frames");
  map.finish();
  if (!frames || !frames.IsSequence() || frames.size() == 0) map.fail("this has no frames");
  for (size_t f = 0; f < frames.size(); ++f) {
    const std::string where = path + ", frame " + std::to_string(f + 1);
    marks.frames.push_back(frameOf(frames[f], where));
    if (f > 0 && marks.frames[f].time_s <= marks.frames[f - 1].time_s)
      throw std::invalid_argument(where + ": its time is not after the one before");
  }
  return marks;
}

struct Ray {
  const Camera* camera;
  Eigen::Vector2d pixel;
};

/// Information of a ray about a point, 1/m^2 for a mark of 1 px.
Eigen::Matrix3d informationOf(const Ray& ray, const Eigen::Vector3d& point) {
  const Eigen::Vector3d d = ray.camera->rayDirection(ray.pixel);
  const double pixels_per_metre =
      ray.camera->calibration().K(0, 0) / std::max(0.1, (point - ray.camera->position()).norm());
  return pixels_per_metre * pixels_per_metre * (Eigen::Matrix3d::Identity() - d * d.transpose());
}

/// The point with the least squared distances, in pixels, from the rays.
Eigen::Vector3d meetingPoint(const std::vector<Ray>& rays) {
  Eigen::Vector3d point = rays[0].camera->position() + rays[0].camera->rayDirection(rays[0].pixel);
  for (int i = 0; i < 5; ++i) {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const Ray& ray : rays) {
      const Eigen::Matrix3d information = informationOf(ray, point);
      A += information;
      b += information * ray.camera->position();
    }
    point = A.ldlt().solve(b);
  }
  return point;
}

double residualOf(const Ray& ray, const Eigen::Vector3d& point) {
  const auto pixel = ray.camera->project(point);
  return pixel ? (*pixel - ray.pixel).norm() : INFINITY;
}

double worstResidual(const std::vector<Ray>& rays) {
  const Eigen::Vector3d point = meetingPoint(rays);
  double worst = 0.0;
  for (const Ray& ray : rays) worst = std::max(worst, residualOf(ray, point));
  return worst;
}

/// Leaves out the ray without which the others agree best, until they agree within the limit.
/// \return the rays that were left out; all if fewer than two agree
std::vector<Ray> leaveOutDisagreeing(double limit_px, std::vector<Ray>* rays) {
  std::vector<Ray> out;
  while (rays->size() >= 2 && worstResidual(*rays) > limit_px) {
    if (rays->size() == 2) {
      out.insert(out.end(), rays->begin(), rays->end());
      rays->clear();
      break;
    }
    size_t best = 0;
    double least = INFINITY;
    for (size_t i = 0; i < rays->size(); ++i) {
      std::vector<Ray> others = *rays;
      others.erase(others.begin() + long(i));
      const double worst = worstResidual(others);
      if (worst < least) least = worst, best = i;
    }
    out.push_back((*rays)[best]);
    rays->erase(rays->begin() + long(best));
  }
  return out;
}

const Camera& cameraNamed(const std::string& name, const CameraRig& rig) {
  std::vector<std::string> names;
  for (const Camera& camera : rig) {
    if (camera.name() == name) return camera;
    names.push_back(camera.name());
  }
  throw std::invalid_argument("the marks are in images of " + name +
                              ", which is not in the rig; it has " + joined(names));
}

std::vector<Ray> raysOf(const std::string& name,
                        const std::map<std::string, Eigen::Vector2d>& marks, double time_s,
                        const CameraRig& rig) {
  std::vector<Ray> rays;
  for (const auto& [camera_name, pixel] : marks) {
    const Camera& camera = cameraNamed(camera_name, rig);
    if (pixel.minCoeff() < -0.5 || pixel.x() > camera.width() - 0.5 ||
        pixel.y() > camera.height() - 0.5)
      throw std::invalid_argument("the mark " + name + " at " + formatNumber("%.3f", time_s) +
                                  " s is outside the image of " + camera_name + ", " +
                                  std::to_string(camera.width()) + " x " +
                                  std::to_string(camera.height()) + " pixels");
    rays.push_back({&camera, pixel});
  }
  return rays;
}

}  // namespace

MarksFile readMarks(const std::string& path) {
  const std::string text = readTextFile(path, "the marks " + path);
  return marksOf(yamlFrom(text, path), path);
}

MarkedTrack triangulated(const MarksFile& marks, const CameraRig& rig, int64_t start_ns) {
  MarkedTrack out;
  out.joints.names = bodyPointNames();
  const double limit = kAgrees * marks.sigma_px;
  double squares = 0.0, spread = 0.0;
  size_t points_found = 0;
  for (const MarkedFrame& frame : marks.frames) {
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Constant(3, long(out.joints.names.size()), NAN);
    for (const auto& [name, in_cameras] : frame.points) {
      std::vector<Ray> rays = raysOf(name, in_cameras, frame.time_s, rig);
      const bool pair = rays.size() == 2;
      for (const Ray& ray : leaveOutDisagreeing(limit, &rays))
        out.disagreements.push_back(
            formatNumber("%.3f", frame.time_s) + " s: " + name + " in " + ray.camera->name() +
            (pair           ? " does not agree with the other camera"
             : rays.empty() ? " agrees with no other camera"
                            : " is " + formatNumber("%.0f", residualOf(ray, meetingPoint(rays))) +
                                  " px from the point of the other cameras"));
      if (rays.size() < 2) continue;
      const Eigen::Vector3d point = meetingPoint(rays);
      points.col(out.joints.indexOf(name)) = point;
      Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
      for (const Ray& ray : rays) {
        information += informationOf(ray, point);
        const double residual = residualOf(ray, point);
        squares += residual * residual;
        out.residual_max_px = std::fmax(out.residual_max_px, residual);
      }
      spread += information.inverse().trace();
      out.marks += rays.size();
      ++points_found;
    }
    out.joints.add(start_ns + std::llround(frame.time_s * 1e9), points);
  }
  if (points_found == 0)
    throw std::invalid_argument("no point is marked in two cameras that agree within " +
                                formatNumber("%.0f", limit) + " px (four sigma_px)");
  out.residual_rms_px = std::sqrt(squares / double(out.marks));
  // Two numbers per mark, three unknowns per point: residuals are smaller than errors.
  const double degrees = std::max(1.0, 2.0 * double(out.marks) - 3.0 * double(points_found));
  const double sigma = std::max(marks.sigma_px, std::sqrt(squares / degrees));
  out.sigma_mm = 1e3 * sigma * std::sqrt(spread / double(points_found));
  return out;
}

}  // namespace markerless_mocap
