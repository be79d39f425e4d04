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
  if (newest_ns_ && stamp_ns - *newest_ns_ > max_jump_ns_) {
    ++counts_.far_future;
    return keepDoubtful(Doubt::kFarFuture, {stream, stamp_ns, std::move(item)});
  }
  if (newest_ns_ && *newest_ns_ - stamp_ns > deadline_ns_) {
    ++counts_.late;
    return keepDoubtful(Doubt::kTooOld, {stream, stamp_ns, std::move(item)});
  }
  doubtful_.clear();
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
    return std::abs(it->first - stamp_ns);
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
auto InstantAssembler<Item>::keepDoubtful(Doubt doubt, Doubtful item) -> std::vector<Instant> {
  if (doubt != doubt_) doubtful_.clear();
  doubt_ = doubt;
  doubtful_.push_back(std::move(item));
  if (doubtful_.size() > streams_ + 1) doubtful_.pop_front();
  if (!timeHasJumped()) return {};

  counts_.abandoned += pending_.size();
  if (doubt == Doubt::kTooOld) ++counts_.time_jumps_back;
  std::deque<Doubtful> start = std::move(doubtful_);
  forget();
  std::vector<Instant> out;
  for (Doubtful& d : start) {
    std::vector<Instant> ready = add(d.stream, d.stamp_ns, std::move(d.item));
    std::move(ready.begin(), ready.end(), std::back_inserter(out));
  }
  return out;
}

template <class Item>
bool InstantAssembler<Item>::timeHasJumped() const {
  if (doubtful_.size() <= streams_) return false;
  const size_t first = doubtful_.front().stream;
  return streams_ == 1 || std::any_of(doubtful_.begin(), doubtful_.end(),
                                      [&](const Doubtful& d) { return d.stream != first; });
}

template <class Item>
void InstantAssembler<Item>::forget() {
  pending_.clear();
  newest_ns_.reset();
  last_out_ns_.reset();
  last_out_present_.clear();
  doubtful_.clear();
}

}  // namespace markerless_mocap
