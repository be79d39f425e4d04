#pragma once

#include <atomic>
#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <vector>

namespace markerless_mocap {

/// Messages to read others into. What nobody holds any more is used again: its arrays have their
/// size already, so that they need not be filled with zeros first. Not thread-safe.
template <class MessageT>
class MessagePool {
 public:
  boost::shared_ptr<MessageT> take() {
    for (const auto& message : kept_)
      if (message.use_count() == 1) {
        std::atomic_thread_fence(std::memory_order_acquire);  // who held it has ended
        return message;
      }
    const auto message = boost::make_shared<MessageT>();
    if (kept_.size() < kKept) kept_.push_back(message);
    return message;
  }

 private:
  static constexpr size_t kKept = 3;  // one that is read, one that is used, the last one
  std::vector<boost::shared_ptr<MessageT>> kept_;
};

}  // namespace markerless_mocap
