#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace markerless_mocap {

/// Items of every n-th frame of a recording whose length is not known: n is doubled, and every
/// second item forgotten, whenever they outgrow a limit.
template <class Item>
class EveryNth {
 public:
  /// \param limit of the sum of the items' sizes
  explicit EveryNth(size_t limit) : limit_(limit) {}

  bool wants(size_t frame) const { return frame % n_ == 0; }
  void add(size_t frame, Item item, size_t size) {
    items_.insert_or_assign(frame, std::make_pair(std::move(item), size));
    total_ += size;
    while (total_ > limit_ && items_.size() > 1) thin();
  }
  /// Every second frame is forgotten, and the others are numbered anew.
  void halveFrames() {
    std::map<size_t, std::pair<Item, size_t>> kept;
    total_ = 0;
    for (auto& [frame, item] : items_)
      if (frame % 2 == 0) {
        total_ += item.second;
        kept.emplace(frame / 2, std::move(item));
      }
    items_ = std::move(kept);
    n_ = std::max<size_t>(1, n_ / 2);
  }
  /// By frame; each with its size.
  const std::map<size_t, std::pair<Item, size_t>>& items() const { return items_; }

 private:
  void thin() {
    n_ *= 2;
    for (auto it = items_.begin(); it != items_.end();)
      if (it->first % n_ == 0) {
        ++it;
      } else {
        total_ -= it->second.second;
        it = items_.erase(it);
      }
  }

  size_t limit_, n_ = 1, total_ = 0;
  std::map<size_t, std::pair<Item, size_t>> items_;
};

}  // namespace markerless_mocap
