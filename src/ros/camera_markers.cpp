#include "ros/camera_markers.h"

#include <tf2_eigen/tf2_eigen.h>

#include <array>

namespace markerless_mocap {
namespace {

std_msgs::ColorRGBA colorOf(CameraHealth::State state) {
  constexpr float kColors[][3] = {
      {0.6f, 0.6f, 0.6f}, {0.35f, 0.85f, 0.4f}, {0.95f, 0.8f, 0.2f}, {0.95f, 0.3f, 0.25f}};
  std_msgs::ColorRGBA color;
  const auto& rgb = kColors[state];
  color.r = rgb[0], color.g = rgb[1], color.b = rgb[2], color.a = 1.0f;
  return color;
}

/// Reasons are sentences for logs; a display has room for their beginning.
std::string shortened(const std::string& reason) {
  constexpr size_t kLetters = 60;
  return reason.size() <= kLetters ? reason : reason.substr(0, kLetters) + " ...";
}

visualization_msgs::Marker marker(const std_msgs::Header& header, const char* ns, int id,
                                  CameraHealth::State state) {
  visualization_msgs::Marker m;
  m.header = header;
  m.ns = ns;
  m.id = id;
  m.pose.orientation.w = 1.0;
  m.color = colorOf(state);
  return m;
}

std::array<Eigen::Vector3d, 4> corners(const Camera& camera, double depth) {
  const double right = camera.width() - 1.0, bottom = camera.height() - 1.0;
  const std::array<Eigen::Vector2d, 4> pixels{
      {{0.0, 0.0}, {right, 0.0}, {right, bottom}, {0.0, bottom}}};
  const Eigen::Vector3d axis = camera.calibration().T_world_camera.linear().col(2);
  std::array<Eigen::Vector3d, 4> points;
  for (size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d ray = camera.rayDirection(pixels[i]);
    points[i] = camera.position() + ray * (depth / ray.dot(axis));
  }
  return points;
}

}  // namespace

visualization_msgs::MarkerArray cameraMarkers(const CameraRig& rig,
                                              const std::vector<CameraHealth>& health,
                                              const std_msgs::Header& header, double depth) {
  visualization_msgs::MarkerArray markers;
  for (size_t i = 0; i < rig.size(); ++i) {
    visualization_msgs::Marker lines =
        marker(header, "frustums", static_cast<int>(i), health[i].state);
    lines.type = lines.LINE_LIST;
    lines.scale.x = 0.01;
    const auto far = corners(rig[i], depth);
    for (size_t c = 0; c < 4; ++c) {
      lines.points.push_back(tf2::toMsg(rig[i].position()));
      lines.points.push_back(tf2::toMsg(far[c]));
      lines.points.push_back(tf2::toMsg(far[c]));
      lines.points.push_back(tf2::toMsg(far[(c + 1) % 4]));
    }
    markers.markers.push_back(lines);
    visualization_msgs::Marker name = marker(header, "names", static_cast<int>(i), health[i].state);
    name.type = name.TEXT_VIEW_FACING;
    name.text = rig[i].name();
    if (!health[i].reason.empty()) name.text += "\n" + shortened(health[i].reason);
    name.scale.z = 0.15;
    name.pose.position =
        tf2::toMsg(Eigen::Vector3d(rig[i].position() + 0.15 * Eigen::Vector3d::UnitZ()));
    markers.markers.push_back(name);
  }
  return markers;
}

}  // namespace markerless_mocap
