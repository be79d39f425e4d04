#include "pipeline/lost_frame_sets.h"

#include <algorithm>
#include <utility>

namespace markerless_mocap {

std::vector<cv::Mat> imagesOf(const std::vector<CameraFrame>& frames) {
  std::vector<cv::Mat> images;
  for (const CameraFrame& frame : frames) images.push_back(frame.image);
  return images;
}

std::vector<double> latenessOf(const std::vector<CameraFrame>& frames) {
  std::vector<double> later_s;
  for (const CameraFrame& frame : frames) later_s.push_back(frame.later_s);
  return later_s;
}

void LostFrameSets::add(const FrameSet& frame_set, std::vector<cv::Mat> masks,
                        const FrameProducts& products) {
  if (lost_.size() == Pipeline::kMostEarlierPoses) lost_.pop_front();
  lost_.push_back({frame_set.stamp_ns, std::move(masks), imagesOf(frame_set.frames),
                   latenessOf(frame_set.frames), ReadyProducts(products), frame_set.owner});
}

std::vector<EarlierPose> LostFrameSets::followedBackBy(BodyTracker& tracker) {
  if (lost_.empty()) return {};  // as nearly always
  std::vector<TrackerInput> earlier;
  for (auto lost = lost_.rbegin(); lost != lost_.rend(); ++lost)
    earlier.push_back(
        {lost->stamp_ns, lost->masks, lost->images, lost->products, {}, false, lost->later_s});
  std::vector<BodyPose> poses = tracker.followBack(earlier);
  std::vector<EarlierPose> found;
  for (size_t i = 0; i < poses.size(); ++i)
    found.push_back({earlier[i].stamp_ns, std::move(poses[i])});
  std::reverse(found.begin(), found.end());
  lost_.clear();
  return found;
}

}  // namespace markerless_mocap
