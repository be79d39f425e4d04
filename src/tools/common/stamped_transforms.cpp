#include "tools/common/stamped_transforms.h"

#include <tf2_eigen/tf2_eigen.h>

#include <cmath>
#include <set>

#include "ros/camera_conversions.h"

namespace markerless_mocap {
namespace {

constexpr int kDeepestTree = 100;

/// Old recordings name frames with a leading slash.
std::string frameName(const std::string& name) {
  return name.rfind('/', 0) == 0 ? name.substr(1) : name;
}

}  // namespace

void StampedTransforms::add(const tf2_msgs::TFMessage& message, bool is_static) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    Parents& parents = is_static ? statics_ : moving_[nanosecondsOf(transform.header.stamp)];
    parents[frameName(transform.child_frame_id)] = {frameName(transform.header.frame_id),
                                                    tf2::transformToEigen(transform)};
  }
}

std::vector<int64_t> StampedTransforms::stampsOf(const std::string& frame) const {
  std::vector<int64_t> stamps;
  for (const auto& entry : moving_)
    if (entry.second.count(frame)) stamps.push_back(entry.first);
  return stamps;
}

std::vector<std::string> StampedTransforms::framesBeginningWith(const std::string& text) const {
  std::set<std::string> frames;
  for (const auto& entry : moving_)
    for (const auto& parent : entry.second)
      if (parent.first.rfind(text, 0) == 0) frames.insert(parent.first);
  return {frames.begin(), frames.end()};
}

StampedTransforms::Place StampedTransforms::find(const std::string& frame, int64_t stamp_ns) const {
  Place place{"", Eigen::Isometry3d::Identity()};
  const auto now = moving_.find(stamp_ns);
  std::string at = frame;
  for (int depth = 0; depth < kDeepestTree; ++depth) {
    const Parent* parent = nullptr;
    if (const auto fixed = statics_.find(at); fixed != statics_.end()) parent = &fixed->second;
    if (now != moving_.end())
      if (const auto moved = now->second.find(at); moved != now->second.end())
        parent = &moved->second;
    if (!parent) break;
    place.root = parent->first;
    place.T_root_frame = parent->second * place.T_root_frame;
    at = parent->first;
  }
  return place;
}

}  // namespace markerless_mocap
