#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "markerless_mocap/camera/instant_assembler.h"

namespace markerless_mocap {

template <class Item>
InstantAssembler<Item>::InstantAssembler(size_t streams, const AssemblerOptions& options)
    : streams_(streams), options_(options) {
  options_.validate(streams);
  tolerance_ns_ = std::llround(options.tolerance * 1e9);
  deadline_ns_ = std::llround(options.deadline * 1e9);
  max_jump_ns_ = std::llround(options.max_jump * 1e9);
}

template <class Item>
auto InstantAssembler<Item>::add(size_t stream, int64_t stamp_ns, Item item)
    -> std::vector<Instant> {
  if (stream >= streams_)
    throw std::invalid_argument("assembler: stream " + std::to_string(stream) + " of " +
                                std::to_string(streams_) + " does not exist");
  const Belief belief = judge(stamp_ns);
  if (belief != Belief::kBelieved) {
    ++(belief == Belief::kTooOld ? counts_.late : counts_.far_future);
    remember({stream, belief, stamp_ns, std::move(item)});
    return timeHasJumped(belief) ? startNewTime(belief) : std::vector<Instant>();
  }
  remember({stream, belief, stamp_ns, Item()});
  newest_ns_ = std::max(newest_ns_.value_or(stamp_ns), stamp_ns);
  insert(stream, stamp_ns, std::move(item));
  return takeReady();
}

template <class Item>
auto InstantAssembler<Item>::flush() -> std::vector<Instant> {
  std::vector<Instant> out;
  while (!pending_.empty()) closeOldest(&out);
  return out;
}

template <class Item>
void InstantAssembler<Item>::reset() {
  forget();
  counts_ = {};
}

template <class Item>
void InstantAssembler<Item>::insert(size_t stream, int64_t stamp_ns, Item item) {
  auto found = findPending(stamp_ns);
  if (found == pending_.end()) {
    if (last_out_ns_ && stamp_ns <= *last_out_ns_ + tolerance_ns_) {
      ++(isLastOut(stream, stamp_ns) ? counts_.duplicate : counts_.late);
      return;
    }
    Instant instant{stamp_ns, std::vector<Item>(streams_), std::vector<bool>(streams_, false)};
    found = pending_.emplace(stamp_ns, std::move(instant)).first;
  }
  Instant& instant = found->second;
  if (instant.present[stream]) {
    ++counts_.duplicate;
    return;
  }
  instant.items[stream] = std::move(item);
  instant.present[stream] = true;
}

template <class Item>
auto InstantAssembler<Item>::findPending(int64_t stamp_ns) -> typename Pending::iterator {
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
bool InstantAssembler<Item>::isLastOut(size_t stream, int64_t stamp_ns) const {
  return std::abs(stamp_ns - *last_out_ns_) <= tolerance_ns_ && last_out_present_[stream];
}

template <class Item>
auto InstantAssembler<Item>::takeReady() -> std::vector<Instant> {
  const auto is_complete = [](const typename Pending::value_type& entry) {
    const std::vector<bool>& present = entry.second.present;
    return std::find(present.begin(), present.end(), false) == present.end();
  };
  std::vector<Instant> out;
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
void InstantAssembler<Item>::closeOldest(std::vector<Instant>* out) {
  Instant instant = std::move(pending_.begin()->second);
  pending_.erase(pending_.begin());
  const size_t present = std::count(instant.present.begin(), instant.present.end(), true);
  if (present < size_t(options_.min_streams)) {
    ++counts_.abandoned;
    return;
  }
  ++(present == streams_ ? counts_.complete : counts_.incomplete);
  last_out_ns_ = instant.stamp_ns;
  last_out_present_ = instant.present;
  out->push_back(std::move(instant));
}

template <class Item>
auto InstantAssembler<Item>::judge(int64_t stamp_ns) const -> Belief {
  if (newest_ns_ && stamp_ns - *newest_ns_ > max_jump_ns_) return Belief::kFarFuture;
  if (newest_ns_ && *newest_ns_ - stamp_ns > deadline_ns_) return Belief::kTooOld;
  return Belief::kBelieved;
}

template <class Item>
void InstantAssembler<Item>::remember(Arrival arrival) {
  recent_.push_back(std::move(arrival));
  if (recent_.size() > 3 * streams_) recent_.pop_front();
}

template <class Item>
bool InstantAssembler<Item>::timeHasJumped(Belief doubt) const {
  std::vector<int> doubts(streams_, 0);  // running, up to the stream's last item
  std::vector<bool> believed(streams_, false);
  for (const Arrival& arrival : recent_) {
    doubts[arrival.stream] = arrival.belief == doubt ? doubts[arrival.stream] + 1 : 0;
    believed[arrival.stream] = arrival.belief == Belief::kBelieved;
  }
  const auto jumped = std::count_if(doubts.begin(), doubts.end(), [](int n) { return n >= 2; });
  return jumped >= options_.min_streams &&
         jumped > std::count(believed.begin(), believed.end(), true);
}

template <class Item>
auto InstantAssembler<Item>::startNewTime(Belief doubt) -> std::vector<Instant> {
  counts_.abandoned += pending_.size();
  if (doubt == Belief::kTooOld) ++counts_.time_jumps_back;
  std::deque<Arrival> arrivals = std::move(recent_);
  forget();
  std::vector<Instant> out;
  for (Arrival& a : arrivals) {
    if (a.belief != doubt) continue;
    std::vector<Instant> ready = add(a.stream, a.stamp_ns, std::move(a.item));
    std::move(ready.begin(), ready.end(), std::back_inserter(out));
  }
  return out;
}

template <class Item>
void InstantAssembler<Item>::forget() {
  pending_.clear();
  newest_ns_.reset();
  last_out_ns_.reset();
  last_out_present_.clear();
  recent_.clear();
}

}  // namespace markerless_mocap
