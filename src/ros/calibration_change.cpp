#include "ros/calibration_change.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace markerless_mocap {
namespace {

constexpr double kMoved = 1e-3;   // m
constexpr double kTurned = 5e-4;  // rad

template <class NumbersT>
bool sameBits(const NumbersT& a, const NumbersT& b) {
  return a.size() == b.size() &&
         (a.size() == 0 || std::memcmp(&a[0], &b[0], a.size() * sizeof(a[0])) == 0);
}

double distance(const geometry_msgs::Transform& a, const geometry_msgs::Transform& b) {
  const auto &p = a.translation, &q = b.translation;
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

double angle(const geometry_msgs::Transform& a, const geometry_msgs::Transform& b) {
  const auto &p = a.rotation, &q = b.rotation;
  const Eigen::Quaterniond from(p.w, p.x, p.y, p.z), to(q.w, q.x, q.y, q.z);
  return from.angularDistance(to);
}

}  // namespace

bool sameCalibration(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b) {
  const auto same_roi = [](const sensor_msgs::RegionOfInterest& r,
                           const sensor_msgs::RegionOfInterest& s) {
    return r.x_offset == s.x_offset && r.y_offset == s.y_offset && r.width == s.width &&
           r.height == s.height;
  };
  return a.header.frame_id == b.header.frame_id && a.width == b.width && a.height == b.height &&
         a.distortion_model == b.distortion_model && sameBits(a.K, b.K) && sameBits(a.D, b.D) &&
         a.binning_x == b.binning_x && a.binning_y == b.binning_y && same_roi(a.roi, b.roi);
}

bool isMoved(const geometry_msgs::Transform& from, const geometry_msgs::Transform& to) {
  return distance(from, to) > kMoved || angle(from, to) > kTurned;
}

std::string distanceText(const geometry_msgs::Transform& from, const geometry_msgs::Transform& to) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f m and %.1f degrees", distance(from, to),
                angle(from, to) * 180.0 / M_PI);
  return text;
}

}  // namespace markerless_mocap
