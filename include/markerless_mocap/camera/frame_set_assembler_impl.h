#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "markerless_mocap/camera/frame_set_assembler.h"

namespace markerless_mocap {

template <class Item>
FrameSetAssembler<Item>::FrameSetAssembler(size_t streams, const AssemblerOptions& options)
    : streams_(streams),
      options_(options),
      offsets_ns_(streams, 0),
      left_out_(streams, 0),
      nearest_(streams),
      lags_(streams),
      presence_(streams, options.silence),
      phases_(streams, options.out_of_step, std::llround(options.tolerance * 1e9)),
      missed_(streams, 0),
      newest_of_ns_(streams) {
  options_.validate(streams);
  deadline_ns_ = std::llround(options.deadline * 1e9);
  max_jump_ns_ = std::llround(options.max_jump * 1e9);
  for (size_t i = 0; i < options.offsets.size(); ++i)
    offsets_ns_[i] = std::llround(options.offsets[i] * 1e9);
}

template <class Item>
auto FrameSetAssembler<Item>::add(size_t stream, int64_t stamp_ns, Item item)
    -> std::vector<FrameSet> {
  requireStream(stream);
  const int64_t time_ns = commonTime(stream, stamp_ns);
  const StampCheck check = checkStamp(stream, time_ns);
  if (check != StampCheck::kPlausible) {
    ++(check == StampCheck::kTooOld ? counts_.late : counts_.far_future);
    remember({stream, check, stamp_ns, std::move(item)});
    return timeHasJumped(check) ? restartAtJump(check) : std::vector<FrameSet>();
  }
  remember({stream, check, stamp_ns, Item()});
  newest_ns_ = std::max(newest_ns_.value_or(time_ns), time_ns);
  newest_of_ns_[stream] = std::max(newest_of_ns_[stream].value_or(time_ns), time_ns);
  presence_.arrived(stream, *newest_ns_);
  phases_.add(stream, time_ns);
  takeBack(stream, time_ns);
  insert(stream, time_ns, std::move(item));
  return takeReady();
}

template <class Item>
void FrameSetAssembler<Item>::requireStream(size_t stream) const {
  if (stream >= streams_)
    throw std::invalid_argument("assembler: stream " + std::to_string(stream) + " of " +
                                std::to_string(streams_) + " does not exist");
}

template <class Item>
void FrameSetAssembler<Item>::foresee(size_t stream, int64_t stamp_ns) {
  requireStream(stream);
  phases_.add(stream, commonTime(stream, stamp_ns));
}

template <class Item>
auto FrameSetAssembler<Item>::flush() -> std::vector<FrameSet> {
  std::vector<FrameSet> out;
  while (!pending_.empty()) closeOldest(&out);
  return out;
}

template <class Item>
void FrameSetAssembler<Item>::reset() {
  forget();
  counts_ = {};
  left_out_.assign(streams_, 0);
  nearest_.assign(streams_, std::nullopt);
}

template <class Item>
StreamTiming FrameSetAssembler<Item>::timing(size_t stream) const {
  const uint64_t left_out = left_out_.at(stream);
  return {1e-9 * lags_.lag_ns(stream), left_out, nearest_[stream], isAwaited(stream)};
}

template <class Item>
void FrameSetAssembler<Item>::noteMissing(const FrameSet& frame_set) {
  for (size_t i = 0; i < streams_; ++i) {
    if (frame_set.present[i]) continue;
    ++left_out_[i];
    if (options_.max_missed > 0 && missed_[i] >= options_.max_missed && sentLately(i))
      continue;  // takeBack() has measured it
    nearest_[i].reset();
    for (const Arrival& arrival : recent_) {
      const double distance = 1e-9 * double(commonTime(i, arrival.stamp_ns) - frame_set.stamp_ns);
      if (arrival.stream == i && !(nearest_[i] && std::abs(*nearest_[i]) <= std::abs(distance)))
        nearest_[i] = distance;
    }
  }
}

template <class Item>
int64_t FrameSetAssembler<Item>::followedLag(size_t stream) const {
  if (phases_.joinsApart()) return 0;  // such lags are no drift
  const double most = 1e9 * options_.max_drift;
  return std::llround(std::clamp(lags_.lag_ns(stream), -most, most));
}

template <class Item>
int64_t FrameSetAssembler<Item>::commonTime(size_t stream, int64_t stamp_ns) const {
  return stamp_ns + offsets_ns_[stream] - followedLag(stream);
}

template <class Item>
void FrameSetAssembler<Item>::measureLags(const FrameSet& frame_set) {
  std::vector<int64_t> times;
  for (size_t i = 0; i < streams_; ++i)
    if (frame_set.present[i]) times.push_back(frame_set.stamps_ns[i]);
  if (times.size() < 2) return;
  std::sort(times.begin(), times.end());
  const int64_t low = times[(times.size() - 1) / 2], high = times[times.size() / 2];
  const int64_t median = low + (high - low) / 2;
  for (size_t i = 0; i < streams_; ++i)
    if (frame_set.present[i])
      lags_.add(i, double(frame_set.stamps_ns[i] - median + followedLag(i)));
  if (options_.max_drift > 0.0) lags_.centre();
}

template <class Item>
void FrameSetAssembler<Item>::insert(size_t stream, int64_t stamp_ns, Item item) {
  auto found = findPending(stamp_ns);
  if (found == pending_.end()) {
    if (last_out_ns_ && stamp_ns <= *last_out_ns_ + phases_.tolerance_ns()) {
      ++(wasInLastFrameSet(stream, stamp_ns) ? counts_.duplicate : counts_.late);
      return;
    }
    FrameSet frame_set{stamp_ns, std::vector<Item>(streams_), std::vector<bool>(streams_, false),
                       std::vector<int64_t>(streams_, 0)};
    found = pending_.emplace(stamp_ns, std::move(frame_set)).first;
  }
  FrameSet& frame_set = found->second;
  if (frame_set.present[stream]) {
    ++counts_.duplicate;
    return;
  }
  frame_set.items[stream] = std::move(item);
  frame_set.present[stream] = true;
  frame_set.stamps_ns[stream] = stamp_ns;
}

template <class Item>
auto FrameSetAssembler<Item>::findPending(int64_t stamp_ns) -> typename Pending::iterator {
  const auto distance = [&](typename Pending::iterator it) {
    return it->first > stamp_ns ? it->first - stamp_ns : stamp_ns - it->first;
  };
  auto nearest = pending_.lower_bound(stamp_ns);
  if (nearest != pending_.begin()) {
    const auto before = std::prev(nearest);
    if (nearest == pending_.end() || distance(before) <= distance(nearest)) nearest = before;
  }
  return nearest != pending_.end() && distance(nearest) <= phases_.tolerance_ns() ? nearest
                                                                                  : pending_.end();
}

template <class Item>
bool FrameSetAssembler<Item>::wasInLastFrameSet(size_t stream, int64_t stamp_ns) const {
  return std::abs(stamp_ns - *last_out_ns_) <= phases_.tolerance_ns() && last_out_present_[stream];
}

template <class Item>
auto FrameSetAssembler<Item>::takeReady() -> std::vector<FrameSet> {
  const auto is_complete = [this](const typename Pending::value_type& entry) {
    return isReady(entry.second);
  };
  std::vector<FrameSet> out;
  const auto complete = std::find_if(pending_.rbegin(), pending_.rend(), is_complete);
  size_t closing = std::distance(complete, pending_.rend());
  while (closing-- > 0) closeOldest(&out);
  while (!pending_.empty() && *newest_ns_ - pending_.begin()->first > deadline_ns())
    closeOldest(&out);
  while (pending_.size() > size_t(options_.max_pending)) {
    closeOldest(&out);  // as at its deadline; dropping all of them would tell nobody why
    ++counts_.overflow;
  }
  return out;
}

template <class Item>
void FrameSetAssembler<Item>::closeOldest(std::vector<FrameSet>* out) {
  FrameSet frame_set = std::move(pending_.begin()->second);
  pending_.erase(pending_.begin());
  const size_t present = std::count(frame_set.present.begin(), frame_set.present.end(), true);
  if (present < size_t(options_.min_streams) || !hasAwaited(frame_set)) {
    ++counts_.abandoned;
    return;
  }
  ++(present == streams_ ? counts_.complete : counts_.incomplete);
  last_out_ns_ = frame_set.stamp_ns;
  last_out_present_ = frame_set.present;
  noteMissing(frame_set);
  noteMissed(frame_set);
  measureLags(frame_set);
  frame_set.stamp_ns = meanStamp(frame_set);
  last_mean_ns_ = frame_set.stamp_ns;
  out->push_back(std::move(frame_set));
}

template <class Item>
int64_t FrameSetAssembler<Item>::meanStamp(const FrameSet& frame_set) const {
  int64_t sum_ns = 0, count = 0;
  for (size_t i = 0; i < streams_; ++i) {
    if (!frame_set.present[i]) continue;
    sum_ns += frame_set.stamps_ns[i] - frame_set.stamp_ns;
    ++count;
  }
  const int64_t mean_ns = frame_set.stamp_ns + sum_ns / count;
  return last_mean_ns_ ? std::max(mean_ns, *last_mean_ns_ + 1) : mean_ns;
}

template <class Item>
bool FrameSetAssembler<Item>::isAwaited(size_t stream) const {
  if (options_.max_missed > 0 && missed_.at(stream) >= options_.max_missed) return false;
  return !presence_.isSilent(stream);
}

template <class Item>
bool FrameSetAssembler<Item>::isMost(const std::vector<bool>& present) const {
  return 2 * size_t(std::count(present.begin(), present.end(), true)) > streams_;
}

template <class Item>
bool FrameSetAssembler<Item>::isReady(const FrameSet& frame_set) const {
  for (size_t i = 0; i < streams_; ++i)
    if (!frame_set.present[i] && isAwaited(i)) return false;
  return hasAwaited(frame_set);
}

template <class Item>
bool FrameSetAssembler<Item>::hasAwaited(const FrameSet& frame_set) const {
  bool any = false;
  for (size_t i = 0; i < streams_; ++i) {
    if (!isAwaited(i)) continue;
    if (frame_set.present[i]) return true;
    any = true;
  }
  return !any;
}

template <class Item>
void FrameSetAssembler<Item>::noteMissed(const FrameSet& frame_set) {
  constexpr size_t kRemembered = 64;
  if (!isMost(frame_set.present)) return;
  closed_ns_.push_back(frame_set.stamp_ns);
  if (closed_ns_.size() > kRemembered) closed_ns_.pop_front();
  for (size_t i = 0; i < streams_; ++i) missed_[i] = frame_set.present[i] ? 0 : missed_[i] + 1;
}

template <class Item>
void FrameSetAssembler<Item>::takeBack(size_t stream, int64_t stamp_ns) {
  if (options_.max_missed == 0 || missed_[stream] < options_.max_missed) return;
  const int64_t distance_ns = fromNearestClosed(stamp_ns);
  if (std::abs(distance_ns) <= phases_.tolerance_ns()) missed_[stream] = 0;
  // The frame set next to this stamp may still be open, but that of a stamp before is closed.
  int64_t nearest_ns = distance_ns;
  for (const Arrival& arrival : recent_) {
    if (arrival.stream != stream) continue;
    const int64_t other_ns = fromNearestClosed(commonTime(stream, arrival.stamp_ns));
    if (std::abs(other_ns) < std::abs(nearest_ns)) nearest_ns = other_ns;
  }
  nearest_[stream] = 1e-9 * double(nearest_ns);
}

template <class Item>
int64_t FrameSetAssembler<Item>::fromNearestClosed(int64_t stamp_ns) const {
  int64_t nearest_ns = std::numeric_limits<int64_t>::max();
  for (const int64_t closed_ns : closed_ns_)
    if (std::abs(stamp_ns - closed_ns) < std::abs(nearest_ns)) nearest_ns = stamp_ns - closed_ns;
  return nearest_ns;
}

template <class Item>
bool FrameSetAssembler<Item>::sentLately(size_t stream) const {
  return std::any_of(recent_.begin(), recent_.end(),
                     [stream](const Arrival& arrival) { return arrival.stream == stream; });
}

// An item that is late, but after all of its stream, is not meant: its camera only lags.
template <class Item>
bool FrameSetAssembler<Item>::wentBack(size_t stream, int64_t stamp_ns) {
  const std::optional<int64_t>& newest = newest_of_ns_[stream];
  return newest && stamp_ns < *newest - phases_.tolerance_ns() && last_out_ns_ &&
         stamp_ns <= *last_out_ns_ + phases_.tolerance_ns() &&
         findPending(stamp_ns) == pending_.end();
}

template <class Item>
auto FrameSetAssembler<Item>::checkStamp(size_t stream, int64_t stamp_ns) -> StampCheck {
  if (newest_ns_ && stamp_ns - *newest_ns_ > max_jump_ns_) return StampCheck::kFarFuture;
  if (newest_ns_ && *newest_ns_ - stamp_ns > deadline_ns()) return StampCheck::kTooOld;
  if (wentBack(stream, stamp_ns)) return StampCheck::kTooOld;
  return StampCheck::kPlausible;
}

template <class Item>
void FrameSetAssembler<Item>::remember(Arrival arrival) {
  recent_.push_back(std::move(arrival));
  if (recent_.size() > 3 * streams_) recent_.pop_front();
}

template <class Item>
bool FrameSetAssembler<Item>::timeHasJumped(StampCheck jump_kind) const {
  std::vector<int> implausible_run(streams_, 0);  // in a row, up to the stream's last item
  std::vector<bool> plausible(streams_, false);
  for (const Arrival& arrival : recent_) {
    implausible_run[arrival.stream] =
        arrival.check == jump_kind ? implausible_run[arrival.stream] + 1 : 0;
    plausible[arrival.stream] = arrival.check == StampCheck::kPlausible;
  }
  const auto jumped =
      std::count_if(implausible_run.begin(), implausible_run.end(), [](int n) { return n >= 2; });
  return jumped >= options_.min_streams &&
         jumped > std::count(plausible.begin(), plausible.end(), true);
}

template <class Item>
auto FrameSetAssembler<Item>::restartAtJump(StampCheck jump_kind) -> std::vector<FrameSet> {
  counts_.abandoned += pending_.size();
  if (jump_kind == StampCheck::kTooOld) ++counts_.time_jumps_back;
  std::deque<Arrival> arrivals = std::move(recent_);
  forget();
  std::vector<FrameSet> out;
  for (Arrival& a : arrivals) {
    if (a.check != jump_kind) continue;
    std::vector<FrameSet> ready = add(a.stream, a.stamp_ns, std::move(a.item));
    std::move(ready.begin(), ready.end(), std::back_inserter(out));
  }
  return out;
}

template <class Item>
void FrameSetAssembler<Item>::forget() {
  pending_.clear();
  newest_ns_.reset();
  last_out_ns_.reset();
  last_mean_ns_.reset();
  last_out_present_.clear();
  recent_.clear();
  lags_.reset();
  presence_.reset();
  phases_.reset();
  missed_.assign(streams_, 0);
  newest_of_ns_.assign(streams_, std::nullopt);
  closed_ns_.clear();
}

}  // namespace markerless_mocap
