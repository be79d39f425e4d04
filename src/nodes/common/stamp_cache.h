#pragma once

#include <cstdint>
#include <cstdlib>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// What has come of several cameras and waits to be asked for by stamp. `Item` is cheap to move and
/// empty when default-constructed.
template <class Item>
class StampCache {
 public:
  /// \param most of one camera; the earliest go when there are more
  StampCache(size_t cameras, size_t most) : waiting_(cameras), last_ns_(cameras), max_size_(most) {}

  void add(size_t camera, int64_t stamp_ns, Item item) {
    auto& waiting = waiting_.at(camera);
    waiting.push_back({stamp_ns, std::move(item)});
    if (waiting.size() > max_size_) waiting.pop_front();
    last_ns_[camera] = stamp_ns;
  }

  /// Whether the camera's last item is earlier than this stamp, but by so little that its next one
  /// may be on its way. Items of a camera come in the order of their stamps.
  bool mayStillCome(size_t camera, int64_t stamp_ns, int64_t tolerance_ns = 0,
                    int64_t max_behind_ns = std::numeric_limits<int64_t>::max()) const {
    const std::optional<int64_t>& last = last_ns_.at(camera);
    return last && *last < stamp_ns - tolerance_ns && *last >= stamp_ns - max_behind_ns;
  }

  /// The item of the nearest stamp within the tolerance, an empty one if there is none. It goes
  /// out, and with it those that came before it: nobody asks for them any more.
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
  std::vector<std::deque<Arrival>> waiting_;  ///< by camera, as they came
  std::vector<std::optional<int64_t>> last_ns_;
  size_t max_size_;
};

}  // namespace markerless_mocap
