#include "ros/body_markers.h"

#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>

#include "ros/pose_conversions.h"
#include "text/joined.h"
#include "tracking/part_of_joint.h"

namespace markerless_mocap {
namespace {

using visualization_msgs::Marker;

constexpr int kSectors = 10, kCapRings = 4;
constexpr double kSmallError = 0.01, kLargeError = 0.05;  // metres: green, red
constexpr float kAlpha = 0.4f;

/// A circle around a round cone's axis.
struct Ring {
  Eigen::Vector3d center;
  double radius;
};

/// Circles from the pole at a to the pole at b, including the spherical caps.
std::vector<Ring> ringsOf(const Eigen::Vector3d& a, double radius_a, const Eigen::Vector3d& b,
                          double radius_b, const Eigen::Vector3d& axis) {
  const double length = (b - a).norm();
  const double slope = length > 0.0 ? (radius_a - radius_b) / length : 0.0;
  const double touch = std::asin(std::clamp(slope, -1.0, 1.0));
  std::vector<Ring> rings;
  const auto add_cap = [&](const Eigen::Vector3d& center, double radius, double from, double to) {
    for (int i = 0; i <= kCapRings; ++i) {
      const double angle = from + (to - from) * i / kCapRings;
      rings.push_back({center + radius * std::sin(angle) * axis, radius * std::cos(angle)});
    }
  };
  add_cap(a, radius_a, -M_PI_2, touch);
  add_cap(b, radius_b, touch, M_PI_2);
  return rings;
}

void addTriangles(const Eigen::Isometry3d& T_world_link, const RoundCone& cone, Marker* marker) {
  const Eigen::Vector3d a = T_world_link * cone.a, b = T_world_link * cone.b;
  const Eigen::Vector3d axis =
      (b - a).norm() > 0.0 ? Eigen::Vector3d((b - a).normalized()) : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const std::vector<Ring> rings = ringsOf(a, cone.radius_a, b, cone.radius_b, axis);
  const auto add_point = [&](const Ring& ring, int sector) {
    const double angle = 2.0 * M_PI * sector / kSectors;
    const Eigen::Vector3d p =
        ring.center + ring.radius * (std::cos(angle) * u + std::sin(angle) * v);
    marker->points.push_back(tf2::toMsg(p));
  };
  for (size_t r = 0; r + 1 < rings.size(); ++r) {
    for (int s = 0; s < kSectors; ++s) {
      add_point(rings[r], s);
      add_point(rings[r], s + 1);
      add_point(rings[r + 1], s + 1);
      add_point(rings[r], s);
      add_point(rings[r + 1], s + 1);
      add_point(rings[r + 1], s);
    }
  }
}

}  // namespace

std_msgs::ColorRGBA colorOfDeviation(double deviation_m) {
  std_msgs::ColorRGBA color;
  color.a = kAlpha;
  color.r = color.g = color.b = 0.75f;
  if (!std::isfinite(deviation_m)) return color;
  const auto badness =
      float(std::clamp((deviation_m - kSmallError) / (kLargeError - kSmallError), 0.0, 1.0));
  color.r = 0.25f + 0.65f * std::min(1.0f, 2.0f * badness);
  color.g = 0.8f - 0.6f * std::max(0.0f, 2.0f * badness - 1.0f);
  color.b = 0.25f;
  return color;
}

visualization_msgs::MarkerArray bodyMarkers(const BodyModel& model, const BodyPose& pose,
                                            const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  array.markers.resize(kPartCount);
  const bool lost = pose.status == PoseStatus::kLost;
  for (size_t part = 0; part < kPartCount; ++part) {
    Marker& marker = array.markers[part];
    marker.header = header;
    marker.ns = "body";
    marker.id = int(part);
    marker.type = Marker::TRIANGLE_LIST;
    marker.action = lost || !pose.part_seen[part] ? Marker::DELETE : Marker::ADD;
    marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
    marker.pose.orientation.w = 1.0;
    marker.color = colorOfDeviation(pose.part_sigma_m[part]);
  }
  if (lost) return array;
  LinkPoses T_world_link;
  model.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
  for (const RoundCone& cone : model.shape()) {
    Marker& marker = array.markers[size_t(partOfLink(model, cone.link))];
    if (marker.action == Marker::ADD) addTriangles(T_world_link[size_t(cone.link)], cone, &marker);
  }
  return array;
}

namespace {

constexpr double kTextHeight = 0.09, kTextAboveHead = 0.35;  // metres
constexpr size_t kLineLength = 44;                           // letters

/// The text in lines of some forty letters.
std::string wrapped(const std::string& text) {
  std::string out;
  size_t line = 0;
  for (const char letter : text) {
    const bool breaks = letter == ' ' && line >= kLineLength;
    out += breaks ? '\n' : letter;
    line = breaks ? 0 : line + 1;
  }
  return out;
}

/// Largest expected error of the parts that are seen; NaN if there is none.
double largestError(const BodyPose& pose) {
  double largest = NAN;
  for (size_t part = 0; part < kPartCount; ++part)
    if (pose.part_seen[part]) largest = std::fmax(largest, pose.part_sigma_m[part]);
  return largest;
}

}  // namespace

std::string poseSummary(const BodyPose& pose) {
  if (pose.status == PoseStatus::kLost) return "lost: " + pose.reason;
  std::string text = "tracked";
  if (std::isfinite(pose.silhouette_overlap))
    text += ", " + std::to_string(std::lround(100 * pose.silhouette_overlap)) + " % overlap";
  if (const double error = largestError(pose); std::isfinite(error))
    text += ", error " + std::to_string(std::lround(1000 * error)) + " mm";
  std::string unseen;
  for (size_t part = 0; part < kPartCount; ++part)
    if (!pose.part_seen[part]) addWord(&unseen, std::string(toString(PartLabel(part))));
  return unseen.empty() ? text : text + "\nnot seen: " + unseen;
}

visualization_msgs::Marker poseTextMarker(const BodyModel& model, const BodyPose& pose,
                                          const std_msgs::Header& header,
                                          std::optional<Eigen::Vector3d>* last_head) {
  const bool lost = pose.status == PoseStatus::kLost;
  if (!lost) {
    LinkPoses T_world_link;
    model.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
    *last_head = T_world_link[size_t(model.linkIndex("head"))].translation();
  }
  const Eigen::Vector3d at = last_head->value_or(Eigen::Vector3d(0, 0, 1.6));
  Marker marker;
  marker.header = header;
  marker.ns = "text";
  marker.type = Marker::TEXT_VIEW_FACING;
  marker.pose.position =
      tf2::toMsg(Eigen::Vector3d(at + kTextAboveHead * Eigen::Vector3d::UnitZ()));
  marker.pose.orientation.w = 1.0;
  marker.scale.z = kTextHeight;
  marker.color.a = marker.color.r = 1.0f;
  marker.color.g = marker.color.b = lost ? 0.5f : 1.0f;
  marker.text = wrapped(poseSummary(pose));
  return marker;
}

}  // namespace markerless_mocap
