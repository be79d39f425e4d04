#pragma once

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
