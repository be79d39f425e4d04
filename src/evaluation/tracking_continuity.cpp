#include "evaluation/tracking_continuity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

bool hasPose(FrameStatus status) {
  return status == FrameStatus::kTracked || status == FrameStatus::kReinitialized;
}

double secondsBetween(int64_t from_ns, int64_t to_ns) {
  return double(to_ns - from_ns) * 1e-9;
}

void countIn(FrameStatus status, TrackingContinuity* record) {
  record->missing += status == FrameStatus::kMissing;
  record->lost += status == FrameStatus::kLost;
  record->tracked += status == FrameStatus::kTracked;
  record->reinitialized += status == FrameStatus::kReinitialized;
}

}  // namespace

const char* toString(FrameStatus status) {
  constexpr const char* kNames[] = {"missing", "lost", "tracked", "reinitialized"};
  return kNames[size_t(status)];
}

double TrackingContinuity::longest_loss() const {
  double longest = 0.0;
  for (const LossRun& run : losses) longest = std::max(longest, run.seconds);
  return longest;
}

TrackingContinuity trackingContinuity(const std::vector<int64_t>& stamps_ns,
                                      const std::vector<FrameStatus>& statuses) {
  if (stamps_ns.size() != statuses.size())
    throw std::invalid_argument("tracking continuity needs one status per stamp");
  TrackingContinuity record;
  record.seconds_to_first_pose = NAN;
  bool begun = false, losing = false;
  for (size_t f = 0; f < statuses.size(); ++f) {
    countIn(statuses[f], &record);
    const bool pose = hasPose(statuses[f]);
    if (pose && !begun) record.seconds_to_first_pose = secondsBetween(stamps_ns[0], stamps_ns[f]);
    begun |= pose;
    if (begun && !pose && !losing) record.losses.push_back({f, 0, 0.0});
    losing = begun && !pose;
    if (losing) ++record.losses.back().frames;
    record.frames_after_start += begun;
  }
  size_t without = 0;
  for (LossRun& run : record.losses) {
    without += run.frames;
    const size_t next = std::min(run.first + run.frames, stamps_ns.size() - 1);
    run.seconds = secondsBetween(stamps_ns[run.first], stamps_ns[next]);
  }
  record.fraction_without_pose_after_start =
      record.frames_after_start == 0 ? NAN : double(without) / double(record.frames_after_start);
  return record;
}

}  // namespace markerless_mocap
