#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace markerless_mocap {

/// The callbacks of one stage, in threads of their own. The threads of a nodelet's manager each
/// have a list of callbacks: what is in the list of a busy thread waits while another has nothing
/// to do. Declare it before what it serves, so that it is destroyed later.
class StageQueue {
 public:
  explicit StageQueue(size_t threads) {
    for (size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  }
  ~StageQueue() {
    ends_ = true;
    queue_.disable();
    for (std::thread& thread : threads_) thread.join();
  }
  StageQueue(const StageQueue&) = delete;
  StageQueue& operator=(const StageQueue&) = delete;

  /// The handle, with this queue for its callbacks.
  ros::NodeHandle served(ros::NodeHandle handle) {
    handle.setCallbackQueue(&queue_);
    return handle;
  }

 private:
  void work() {
    const ros::WallDuration patience(0.1);
    // Of a topic whose last message is still in use, the next one has to wait.
    while (!ends_)
      if (queue_.callOne(patience) == ros::CallbackQueue::TryAgain)
        std::this_thread::sleep_for(std::chrono::microseconds(100));
  }

  ros::CallbackQueue queue_;
  std::atomic<bool> ends_{false};
  std::vector<std::thread> threads_;
};

}  // namespace markerless_mocap
