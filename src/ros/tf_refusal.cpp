#include "ros/tf_refusal.h"

#include <cmath>

namespace markerless_mocap {

std::string tfRefusal(const geometry_msgs::TransformStamped& transform) {
  constexpr double kTolerance = 1e-2;  // of tf2
  if (transform.child_frame_id.empty() || transform.header.frame_id.empty())
    return "one of its frames has no name";
  if (transform.child_frame_id == transform.header.frame_id) return "the frame is its own parent";
  const auto& t = transform.transform.translation;
  const auto& q = transform.transform.rotation;
  if (std::isnan(t.x + t.y + t.z) || std::isnan(q.x + q.y + q.z + q.w))
    return "it holds a value that is not a number";
  const double square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!(std::abs(square - 1.0) < kTolerance))
    return "its quaternion has length " + std::to_string(std::sqrt(square)) + ", allowed is 1";
  return "";
}

}  // namespace markerless_mocap
