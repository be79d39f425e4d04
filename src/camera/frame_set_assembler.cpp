#include "markerless_mocap/camera/frame_set_assembler.h"

#include <algorithm>
#include <sstream>

namespace markerless_mocap {
namespace {

template <class T>
void checkRange(const char* key, T value, T min_value, T max_value) {
  if (value >= min_value && value <= max_value) return;  // NaN fails
  std::ostringstream message;
  message << "assembler/" << key << " is " << value << ", allowed is " << min_value << " to "
          << max_value;
  throw std::invalid_argument(message.str());
}

}  // namespace

void AssemblerOptions::validate(size_t streams) const {
  if (streams == 0) throw std::invalid_argument("assembler: there are no streams to join");
  checkRange("tolerance", tolerance, 0.0, 1.0);
  checkRange("deadline", deadline, tolerance, 60.0);
  checkRange("max_jump", max_jump, deadline, 86400.0);
  checkRange("min_streams", min_streams, 1, int(streams));
  checkRange("max_pending", max_pending, 1, 1000);
  checkRange("max_drift", max_drift, 0.0, 60.0);
  checkRange("silence", silence, 0.0, 60.0);
  checkRange("max_missed", max_missed, 0, 1000);
  if (!offsets.empty() && offsets.size() != streams)
    throw std::invalid_argument("assembler/offsets has " + std::to_string(offsets.size()) +
                                " values, allowed is one for each of the " +
                                std::to_string(streams) + " streams");
  for (const double offset : offsets) checkRange("offsets", offset, -86400.0, 86400.0);
}

void LagEstimate::add(size_t stream, double lag_ns) {
  constexpr uint64_t kAveraged = 100;  // items
  const uint64_t count = std::min(++counts_[stream], kAveraged);
  lags_ns_[stream] += (lag_ns - lags_ns_[stream]) / double(count);
}

void LagEstimate::centre() {
  std::vector<double> sorted = lags_ns_;
  std::sort(sorted.begin(), sorted.end());
  const double median = (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2.0;
  for (double& lag : lags_ns_) lag -= median;
}

void LagEstimate::reset() {
  std::fill(lags_ns_.begin(), lags_ns_.end(), 0.0);
  std::fill(counts_.begin(), counts_.end(), 0);
}

void StreamPresence::arrived(size_t stream, int64_t newest_ns) {
  constexpr uint64_t kAveraged = 20;  // items
  const auto longest = int64_t(1e9 * silence_ / 3.0);
  now_ns_ += std::min(newest_ns - newest_ns_.value_or(newest_ns), longest);
  newest_ns_ = newest_ns;
  State& state = streams_[stream];
  if (state.count > 0)
    state.gap_ns +=
        (double(now_ns_ - state.last_ns) - state.gap_ns) / double(std::min(state.count, kAveraged));
  ++state.count;
  state.last_ns = now_ns_;
}

bool StreamPresence::isSilent(size_t stream) const {
  constexpr double kUnknownGap = 1e9 / 3.0;  // a stream that has not sent twice may be starting
  if (silence_ == 0.0) return false;
  const State& state = streams_[stream];
  const double gap = state.count > 1 ? state.gap_ns : kUnknownGap;
  return double(now_ns_ - state.last_ns) > std::max(1e9 * silence_, 3.0 * gap);
}

void StreamPresence::reset() {
  streams_.assign(streams_.size(), {});
  newest_ns_.reset();
  now_ns_ = 0;
}

}  // namespace markerless_mocap
