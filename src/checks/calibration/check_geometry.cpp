#include <algorithm>
#include <cmath>

#include "checks/calibration/check_calibration.h"
#include "checks/text/sentence.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr double kFarApart = 100.0;          // m, median distance of cameras in no studio
constexpr double kMillimetresFrom = 1500.0;  // the same; below, centimetres
constexpr double kShared = 0.005;            // of the places that a camera sees
constexpr double kSamePlace = 0.01, kSameDirection = 1.0 * M_PI / 180;  // m, rad

std::vector<Camera> calibrated(const SeenRig& rig) {
  std::vector<Camera> cameras;
  for (const SeenCamera& camera : rig.cameras)
    if (const auto calibration = calibrationOf(camera)) cameras.emplace_back(*calibration);
  return cameras;
}

double usualDistance(const std::vector<Camera>& cameras) {
  std::vector<double> distances;
  for (size_t i = 0; i < cameras.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      distances.push_back((cameras[i].position() - cameras[j].position()).norm());
  return nearestQuantile(distances, 0.5);
}

void checkUnits(double distance, Findings* findings) {
  if (distance < kFarApart) return;
  const bool milli = distance > kMillimetresFrom;
  findings->push_back(
      {"units_not_metres", "", Severity::kError,
       sentence("the cameras are %.0f m from each other (median); in %s it would be "
                "%.2f m",
                distance, milli ? "millimetres" : "centimetres", distance / (milli ? 1000 : 100)),
       milli ? "divide all translations by 1000: convert_calibration --scale 0.001"
             : "divide all translations by 100: convert_calibration --scale 0.01"});
}

/// By the upward direction of the images: people hold or mount cameras upright.
void checkUp(const std::vector<Camera>& cameras, Findings* findings) {
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  for (const Camera& camera : cameras)
    up -= camera.calibration().T_world_camera.linear().col(1) / double(cameras.size());
  int axis = 0;
  const double length = up.norm();
  up.cwiseAbs().maxCoeff(&axis);
  if (length < 0.3 || std::abs(up[axis]) < 0.85 * length || (axis == 2 && up.z() > 0)) return;
  const std::string direction = std::string(up[axis] > 0 ? "+" : "-") + "xyz"[axis];
  findings->push_back(
      {axis == 2 ? "world_z_down" : "world_z_not_up", "", Severity::kError,
       "the upper borders of the images lie towards " + direction + " of the world",
       axis == 2
           ? "the world must have z up: turn all poses by 180 degrees about the world's x axis "
             "(convert_calibration)"
           : "the world must have z up: turn all poses so that " + direction +
                 " becomes +z (convert_calibration)"});
}

void checkPlaces(const std::vector<Camera>& cameras, Findings* findings) {
  for (size_t i = 0; i < cameras.size(); ++i)
    for (size_t j = i + 1; j < cameras.size(); ++j) {
      const Eigen::Isometry3d between = cameras[i].calibration().T_world_camera.inverse() *
                                        cameras[j].calibration().T_world_camera;
      const double turn = Eigen::AngleAxisd(between.linear()).angle();
      if (between.translation().norm() > kSamePlace || turn > kSameDirection) continue;
      findings->push_back(
          {"poses_identical", cameras[i].name() + ", " + cameras[j].name(), Severity::kError,
           sentence("the poses differ by %.1f mm and %.2f degrees",
                    1e3 * between.translation().norm(), turn * 180 / M_PI),
           "one camera was given the other's transform: look at the frame_id of both camera_info"});
    }
}

/// Places in front of a camera, on a lattice of its image and some distances.
std::vector<Eigen::Vector3d> viewOf(const Camera& camera, double scale) {
  std::vector<Eigen::Vector3d> points;
  for (int x = 1; x < 8; ++x)
    for (int y = 1; y < 6; ++y)
      for (double depth = 0.1; depth < 3.0; depth *= 1.25)
        points.push_back(camera.position() + depth * scale *
                                                 camera.rayDirection({x * camera.width() / 8.0,
                                                                      y * camera.height() / 6.0}));
  return points;
}

/// Of how many other cameras there are places, more than a few, that this one sees, too.
int shareWithOthers(const Camera& camera, const std::vector<Camera>& cameras, double scale) {
  std::vector<double> others;  // at each place
  for (const Eigen::Vector3d& place : viewOf(camera, scale))
    others.push_back(double(std::count_if(cameras.begin(), cameras.end(), [&](const Camera& other) {
      return &other != &camera && other.projectInside(place).has_value();
    })));
  return int(nearestQuantile(std::move(others), 1 - kShared));
}

/// A camera that looks out of the room still sees what those across the room see behind it, so
/// more than half as many must see a place as usually do.
void checkCommonVolume(const std::vector<Camera>& cameras, double scale, Findings* findings) {
  if (cameras.size() < 2 || scale <= 0) return;
  std::vector<double> shared;
  for (const Camera& camera : cameras) shared.push_back(shareWithOthers(camera, cameras, scale));
  const int enough =
      std::max(cameras.size() > 3 ? 2 : 1, int(nearestQuantile(shared, 0.5)) / 2 + 1);
  for (size_t i = 0; i < cameras.size(); ++i) {
    if (shared[i] >= enough) continue;
    findings->push_back(
        {"no_common_volume", cameras[i].name(), Severity::kError,
         sentence("fewer than %d of the other cameras see any place that this one "
                  "sees",
                  enough),
         "look at the cameras in rviz (docs/troubleshooting.md); turn the camera to "
         "the middle of the room, or correct its transform"});
  }
}

}  // namespace

void checkGeometry(const SeenRig& rig, Findings* findings) {
  const std::vector<Camera> cameras = calibrated(rig);
  if (cameras.size() < 2) return;
  const double distance = usualDistance(cameras);
  checkUnits(distance, findings);
  checkUp(cameras, findings);
  checkPlaces(cameras, findings);
  checkCommonVolume(cameras, distance, findings);
}

}  // namespace markerless_mocap
