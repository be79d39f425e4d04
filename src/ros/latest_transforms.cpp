#include "ros/latest_transforms.h"

#include "ros/tf_refusal.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMostFaults = 256;

}  // namespace

void LatestTransforms::add(const tf2_msgs::TFMessage& message, const std::string& sender,
                           bool is_static, int64_t arrival_ns) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (geometry_msgs::TransformStamped transform : message.transforms) {
    const std::string why = tfRefusal(transform);
    if (why.empty()) {
      transform.header.stamp.fromNSec(uint64_t(arrival_ns));
      buffer_.setTransform(transform, sender, is_static);
      faults_.erase(transform.child_frame_id);
    } else if (faults_.size() < kMostFaults) {
      faults_[transform.child_frame_id] = sender + " has sent a transform of " +
                                          transform.child_frame_id +
                                          " to tf that is not used: " + why;
    }
  }
}

std::vector<std::string> LatestTransforms::faults(const RigCollector& rig) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::string> sentences;
  for (const auto& [frame, sentence] : faults_)
    if (rig.dependsOn(frame, buffer_)) sentences.push_back(sentence);
  return sentences;
}

}  // namespace markerless_mocap
