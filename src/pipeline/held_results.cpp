#include "pipeline/held_results.h"

namespace markerless_mocap {

void HeldResults::add(const FrameSet& frame_set, PipelineResult result) {
  if (!result.learning && result.pose.status == PoseStatus::kLost) {
    if (held_.size() == Pipeline::kMostEarlierPoses) passOldestOn();
    held_.push_back({frame_set, std::move(result)});
    return;
  }
  takeEarlierPoses(result.earlier_poses, result.pose);
  passOn();
  sink_(frame_set, result);
}

void HeldResults::takeEarlierPoses(const std::vector<EarlierPose>& earlier, BodyPose& pose) {
  PoseStatus* first = nullptr;
  auto next = earlier.begin();
  for (Held& held : held_) {
    while (next != earlier.end() && next->stamp_ns < held.frame_set.stamp_ns) ++next;
    if (next == earlier.end() || next->stamp_ns != held.frame_set.stamp_ns) continue;
    held.result.pose = next->pose;
    if (!first) first = &held.result.pose.status;
  }
  if (first) std::swap(*first, pose.status);
}

void HeldResults::passOldestOn() {
  sink_(held_.front().frame_set, held_.front().result);
  held_.pop_front();
}

void HeldResults::passOn() {
  while (!held_.empty()) passOldestOn();
}

}  // namespace markerless_mocap
