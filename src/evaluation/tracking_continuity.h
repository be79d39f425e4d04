#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Status of a tracker in a frame of the truth. kMissing: there is no result for the frame.
enum class FrameStatus { kMissing, kLost, kTracked, kReinitialized };
const char* toString(FrameStatus status);

/// Consecutive frames without a pose.
struct LossRun {
  size_t first = 0, frames = 0;
  double seconds = 0.0;  ///< until the next pose or the end
};

/// Continuity of tracking over a sequence.
struct TrackingContinuity {
  size_t missing = 0;  ///< frames without a result
  size_t lost = 0, tracked = 0, reinitialized = 0;
  double seconds_to_first_pose;              ///< from the first frame; NaN without a pose
  std::vector<LossRun> losses;               ///< lost or missing, after the first pose
  size_t frames_after_start = 0;             ///< from the first pose on
  double fraction_without_pose_after_start;  ///< fraction of frames_after_start; NaN without a pose
  double longest_loss() const;               ///< seconds; 0 without losses
};

/// Throws std::invalid_argument unless there is one stamp per status.
TrackingContinuity trackingContinuity(const std::vector<int64_t>& stamps_ns,
                                      const std::vector<FrameStatus>& statuses);

}  // namespace markerless_mocap
