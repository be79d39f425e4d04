#pragma once

#include <cstdint>
#include <cstdlib>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// Messages of several cameras, kept until they are looked up by stamp. `Item` is cheap to move and
/// empty if default-constructed.
template <class Item>
class StampCache {
 public:
  /// \param max_size maximum number per camera; the oldest are dropped
  StampCache(size_t cameras, size_t max_size)
      : waiting_(cameras), last_ns_(cameras), max_size_(max_size) {}

  void add(size_t camera, int64_t stamp_ns, Item item) {
    auto& waiting = waiting_.at(camera);
    waiting.push_back({stamp_ns, std::move(item)});
    if (waiting.size() > max_size_) waiting.pop_front();
    last_ns_[camera] = stamp_ns;
  }

  /// True if the last item of the camera is earlier than this stamp, but only by so little that the
  /// next one may still arrive. Items of a camera must arrive in the order of their stamps.
  bool mayStillCome(size_t camera, int64_t stamp_ns, int64_t tolerance_ns = 0,
                    int64_t max_behind_ns = std::numeric_limits<int64_t>::max()) const {
    const std::optional<int64_t>& last = last_ns_.at(camera);
    return last && *last < stamp_ns - tolerance_ns && *last >= stamp_ns - max_behind_ns;
  }

  /// Removes and returns the item with the nearest stamp within the tolerance; empty if there is
  /// none. Earlier items of the camera are dropped, too.
  Item take(size_t camera, int64_t stamp_ns, int64_t tolerance_ns = 0) {
    auto& waiting = waiting_.at(camera);
    auto nearest = waiting.end();
    for (auto it = waiting.begin(); it != waiting.end(); ++it) {
      const int64_t distance = std::abs(it->stamp_ns - stamp_ns);
      if (distance > tolerance_ns) continue;
      if (nearest == waiting.end() || distance <= std::abs(nearest->stamp_ns - stamp_ns))
        nearest = it;
    }
    if (nearest == waiting.end()) return Item();
    Item item = std::move(nearest->item);
    waiting.erase(waiting.begin(), std::next(nearest));
    return item;
  }

 private:
  struct Arrival {
    int64_t stamp_ns;
    Item item;
  };
  std::vector<std::deque<Arrival>> waiting_;  ///< by camera, in the order of arrival
  std::vector<std::optional<int64_t>> last_ns_;
  size_t max_size_;
};

}  // namespace markerless_mocap
