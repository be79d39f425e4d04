#include "nodes/common/mask_sets.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "camera/timing_remarks.h"
#include "ros/camera_conversions.h"

namespace markerless_mocap {
namespace {

constexpr double kSilence = 0.3;   // s until sets no longer wait for a camera
constexpr int kMaxMissed = 5;      // sets until they no longer wait for a camera with other stamps
constexpr size_t kMaxWaiting = 3;  // sets that wait for their images
constexpr int64_t kStrayTime = 500'000'000;  // ns

AssemblerOptions assemblerOptions(const MaskSets::Rules& rules) {
  AssemblerOptions options;
  options.tolerance = rules.tolerance;
  options.deadline = rules.deadline;
  options.min_streams = 1;  // so that sets with too few cameras are told, too
  options.offsets = rules.offsets;
  if (!options.offsets.empty()) options.max_drift = kFollowedDrift;
  options.silence = kSilence;
  options.max_missed = kMaxMissed;
  options.out_of_step = OutOfStep::kJoinIfNever;
  return options;
}

}  // namespace

size_t countOf(const MaskSet& set) {
  return size_t(std::count(set.present.begin(), set.present.end(), true));
}

std::string lackOfMasks(size_t present, size_t cameras, size_t required) {
  return "the frame set has the masks of " + std::to_string(present) + " of " +
         std::to_string(cameras) + " cameras, at least " + std::to_string(required) +
         " are needed within the deadline";
}

MaskSets::MaskSets(const Rules& rules, std::function<bool(const MaskSet&)> must_wait,
                   std::function<void(const MaskSet&)> sink)
    : required_(rules.required),
      options_(assemblerOptions(rules)),
      assembler_(rules.cameras, options_),
      waiting_(kMaxWaiting),
      must_wait_(std::move(must_wait)),
      sink_(std::move(sink)) {}

void MaskSets::add(size_t camera, const sensor_msgs::ImageConstPtr& mask) {
  const uint64_t jumps = assembler_.counts().time_jumps_back;
  auto sets = assembler_.add(camera, nanosecondsOf(mask->header.stamp), mask);
  if (assembler_.counts().time_jumps_back != jumps) waiting_.clear();
  for (MaskSet& set : sets) waiting_.push(std::move(set));
  passOn();
}

void MaskSets::passOn() {
  waiting_.release(must_wait_, sink_);
}

bool MaskSets::isStray(const MaskSet& set) const {
  return countOf(set) < required_ && last_used_ns_ &&
         std::abs(set.stamp_ns - *last_used_ns_) < kStrayTime;
}

}  // namespace markerless_mocap
