#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "markerless_mocap/camera/frame_set_assembler.h"

namespace markerless_mocap {

template <class Item>
FrameSetAssembler<Item>::FrameSetAssembler(size_t streams, const AssemblerOptions& options)
    : streams_(streams), options_(options) {
  options_.validate(streams);
  tolerance_ns_ = std::llround(options.tolerance * 1e9);
  deadline_ns_ = std::llround(options.deadline * 1e9);
  max_jump_ns_ = std::llround(options.max_jump * 1e9);
}

template <class Item>
auto FrameSetAssembler<Item>::add(size_t stream, int64_t stamp_ns, Item item)
    -> std::vector<FrameSet> {
  if (stream >= streams_)
    throw std::invalid_argument("assembler: stream " + std::to_string(stream) + " of " +
                                std::to_string(streams_) + " does not exist");
  const StampCheck check = checkStamp(stamp_ns);
  if (check != StampCheck::kPlausible) {
    ++(check == StampCheck::kTooOld ? counts_.late : counts_.far_future);
    remember({stream, check, stamp_ns, std::move(item)});
    return timeHasJumped(check) ? restartAtJump(check) : std::vector<FrameSet>();
  }
  remember({stream, check, stamp_ns, Item()});
  newest_ns_ = std::max(newest_ns_.value_or(stamp_ns), stamp_ns);
  insert(stream, stamp_ns, std::move(item));
  return takeReady();
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
}

template <class Item>
void FrameSetAssembler<Item>::insert(size_t stream, int64_t stamp_ns, Item item) {
  auto found = findPending(stamp_ns);
  if (found == pending_.end()) {
    if (last_out_ns_ && stamp_ns <= *last_out_ns_ + tolerance_ns_) {
      ++(wasInLastFrameSet(stream, stamp_ns) ? counts_.duplicate : counts_.late);
      return;
    }
    FrameSet frame_set{stamp_ns, std::vector<Item>(streams_), std::vector<bool>(streams_, false)};
    found = pending_.emplace(stamp_ns, std::move(frame_set)).first;
  }
  FrameSet& frame_set = found->second;
  if (frame_set.present[stream]) {
    ++counts_.duplicate;
    return;
  }
  frame_set.items[stream] = std::move(item);
  frame_set.present[stream] = true;
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
  return nearest != pending_.end() && distance(nearest) <= tolerance_ns_ ? nearest : pending_.end();
}

template <class Item>
bool FrameSetAssembler<Item>::wasInLastFrameSet(size_t stream, int64_t stamp_ns) const {
  return std::abs(stamp_ns - *last_out_ns_) <= tolerance_ns_ && last_out_present_[stream];
}

template <class Item>
auto FrameSetAssembler<Item>::takeReady() -> std::vector<FrameSet> {
  const auto is_complete = [](const typename Pending::value_type& entry) {
    const std::vector<bool>& present = entry.second.present;
    return std::find(present.begin(), present.end(), false) == present.end();
  };
  std::vector<FrameSet> out;
  const auto complete = std::find_if(pending_.rbegin(), pending_.rend(), is_complete);
  size_t closing = std::distance(complete, pending_.rend());
  while (closing-- > 0) closeOldest(&out);
  while (!pending_.empty() && *newest_ns_ - pending_.begin()->first > deadline_ns_)
    closeOldest(&out);
  while (pending_.size() > size_t(options_.max_pending)) {
    pending_.erase(pending_.begin());
    ++counts_.overflow;
  }
  return out;
}

template <class Item>
void FrameSetAssembler<Item>::closeOldest(std::vector<FrameSet>* out) {
  FrameSet frame_set = std::move(pending_.begin()->second);
  pending_.erase(pending_.begin());
  const size_t present = std::count(frame_set.present.begin(), frame_set.present.end(), true);
  if (present < size_t(options_.min_streams)) {
    ++counts_.abandoned;
    return;
  }
  ++(present == streams_ ? counts_.complete : counts_.incomplete);
  last_out_ns_ = frame_set.stamp_ns;
  last_out_present_ = frame_set.present;
  out->push_back(std::move(frame_set));
}

template <class Item>
auto FrameSetAssembler<Item>::checkStamp(int64_t stamp_ns) const -> StampCheck {
  if (newest_ns_ && stamp_ns - *newest_ns_ > max_jump_ns_) return StampCheck::kFarFuture;
  if (newest_ns_ && *newest_ns_ - stamp_ns > deadline_ns_) return StampCheck::kTooOld;
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
  last_out_present_.clear();
  recent_.clear();
}

}  // namespace markerless_mocap
