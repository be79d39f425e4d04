// How ContourTracker follows the person back in time.
#include <tuple>
#include <utility>

#include "contour/contour_tracker.h"

namespace markerless_mocap {
namespace {

template <class... Members>
std::tuple<Members...> copyOf(const std::tuple<Members&...>& members) {
  return members;
}

std::vector<double> negative(std::vector<double> seconds) {
  for (double& value : seconds) value = -value;
  return seconds;
}

}  // namespace

auto ContourTracker::state() {
  return std::tie(hypotheses_, wanted_images_, contradicted_, person_.converter(), trust_, starts_,
                  learning_, reconsideration_, search_in_doubt_, limb_search_, fresh_until_ns_,
                  goes_back_, reported_, is_at_person_, lost_reason_, stamp_, gap_ns_);
}

// Time is mirrored at the last frame: it goes on, but the person moves backwards.
std::vector<BodyPose> ContourTracker::followBack(const std::vector<TrackerInput>& earlier) {
  std::vector<BodyPose> poses;
  if (!reported_ || person_.isBeingMeasured() || person_.resources().in_background) return poses;
  auto before = copyOf(state());
  const int64_t turned_at_ns = *stamp_;
  hypotheses_.turnBack();
  goes_back_ = true;
  for (const TrackerInput& now : earlier) {
    BodyPose pose = update({2 * turned_at_ns - now.stamp_ns,
                            now.masks,
                            now.images,
                            now.products,
                            {},
                            false,
                            negative(now.later_s)});
    if (pose.status == PoseStatus::kLost) break;
    poses.push_back(std::move(pose));
  }
  state() = std::move(before);
  return poses;
}

}  // namespace markerless_mocap
