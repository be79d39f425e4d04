#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// What a tracker said about a frame of the truth.
enum class FrameStatus { kMissing, kLost, kTracked, kReinitialized };
const char* toString(FrameStatus status);

/// Frames in a row without a pose.
struct LossRun {
  size_t first = 0, frames = 0;
  double seconds = 0.0;  ///< until the next pose, or to the end
};

/// How well a tracker kept its person.
struct TrackingContinuity {
  size_t missing = 0;  ///< nothing was said about the frame
  size_t lost = 0, tracked = 0, reinitialized = 0;
  double seconds_to_first_pose;              ///< from the first frame; NaN without any pose
  std::vector<LossRun> losses;               ///< lost or missing, after the first pose
  size_t frames_after_start = 0;             ///< from the first pose on
  double fraction_without_pose_after_start;  ///< of these; NaN without any pose
  double longest_loss() const;               ///< seconds; 0 without losses
};

/// Throws std::invalid_argument unless there is a stamp for each status.
TrackingContinuity trackingContinuity(const std::vector<int64_t>& stamps_ns,
                                      const std::vector<FrameStatus>& statuses);

}  // namespace markerless_mocap
