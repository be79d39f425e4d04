#include "ros/volume_markers.h"

#include <tf2_eigen/tf2_eigen.h>

#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;

constexpr double kArrows = 0.5;        // m, size of the handles
constexpr double kLineWidth = 0.012;   // m
constexpr double kBallDiameter = 0.1;  // m

Marker marker(int type) {
  Marker m;
  m.type = type;
  m.pose.orientation.w = 1.0;
  m.color.r = 0.35f, m.color.g = 0.7f, m.color.b = 1.0f, m.color.a = 0.9f;
  return m;
}

/// The twelve edges, relative to the corner whose marker shows them.
Marker edgesOf(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& corner) {
  Marker lines = marker(Marker::LINE_LIST);
  lines.scale.x = kLineWidth;
  for (int from = 0; from < 8; ++from)
    for (int axis = 0; axis < 3; ++axis) {
      const int to = from | (1 << axis);
      if (to == from) continue;
      for (const int end : {from, to})
        lines.points.push_back(
            tf2::toMsg(Eigen::Vector3d(box.corner(Eigen::AlignedBox3d::CornerType(end)) - corner)));
    }
  return lines;
}

/// A handle that moves along an axis. A control's axis is the x-axis of its orientation.
InteractiveMarkerControl moveAlong(int axis) {
  InteractiveMarkerControl control;
  control.name = std::string("move_") + "xyz"[axis];
  control.interaction_mode = InteractiveMarkerControl::MOVE_AXIS;
  control.orientation =
      tf2::toMsg(shortestRotation(Eigen::Vector3d::UnitX(), Eigen::Vector3d::Unit(axis)));
  return control;
}

InteractiveMarkerControl menuOn(const Marker& shape) {
  InteractiveMarkerControl control;
  control.name = "menu";
  control.interaction_mode = InteractiveMarkerControl::MENU;
  control.always_visible = true;
  control.markers.push_back(shape);
  return control;
}

}  // namespace

InteractiveMarker cornerMarker(const std::string& name, const Eigen::AlignedBox3d& box,
                               const std::string& frame) {
  const bool low = name == kLowCorner;
  const Eigen::Vector3d corner = low ? box.min() : box.max();
  InteractiveMarker handle;
  handle.header.frame_id = frame;
  handle.name = name;
  handle.description = low ? "volume" : "";
  handle.scale = kArrows;
  handle.pose.position = tf2::toMsg(corner);
  handle.pose.orientation.w = 1.0;
  for (int axis = 0; axis < 3; ++axis) handle.controls.push_back(moveAlong(axis));
  Marker ball = marker(Marker::SPHERE);
  ball.scale.x = ball.scale.y = ball.scale.z = kBallDiameter;
  handle.controls.push_back(menuOn(ball));
  if (low) {
    InteractiveMarkerControl edges;
    edges.name = "edges";
    edges.interaction_mode = InteractiveMarkerControl::NONE;
    edges.always_visible = true;
    edges.markers.push_back(edgesOf(box, corner));
    handle.controls.push_back(edges);
  }
  return handle;
}

}  // namespace markerless_mocap
