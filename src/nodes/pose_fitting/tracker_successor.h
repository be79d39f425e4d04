#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <memory>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/tracking/body_tracker.h"

namespace markerless_mocap {

/// Makes the tracker of a rig that has changed, and lets it look for the person in a thread beside
/// the tracker of the old rig, so that there is no gap.
class TrackerSuccessor {
 public:
  using Make = std::function<std::unique_ptr<BodyTracker>()>;
  using Update = std::function<BodyPose(BodyTracker&)>;

  /// Lets the tracker of `rig` see a frame set, unless it is still busy with an earlier one.
  /// \return the tracker as soon as it has found the person; null before
  std::unique_ptr<BodyTracker> look(const std::shared_ptr<const CameraRig>& rig, const Make& make,
                                    const Update& update) {
    if (rig_ != rig) forget();
    rig_ = rig;
    if (look_.valid()) {
      if (look_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return nullptr;
      if (look_.get()) return take();
    }
    look_ = std::async(std::launch::async, [this, make, update] { return hasFound(make, update); });
    return nullptr;
  }
  /// What has been made of this rig so far, else null.
  std::unique_ptr<BodyTracker> takeOf(const std::shared_ptr<const CameraRig>& rig) {
    if (rig_ != rig) forget();
    return take();
  }
  void forget() { take().reset(); }

 private:
  std::unique_ptr<BodyTracker> take() {
    if (look_.valid()) look_.get();  // waits
    rig_.reset();
    return std::move(tracker_);
  }
  bool hasFound(const Make& make, const Update& update) {
    try {
      if (!tracker_) tracker_ = make();
      return update(*tracker_).status != PoseStatus::kLost;
    } catch (const std::exception&) {
      return false;  // told when the old tracker is given up
    }
  }

  std::shared_ptr<const CameraRig> rig_;
  std::unique_ptr<BodyTracker> tracker_;  ///< only for the thread while it looks
  std::future<bool> look_;
};

}  // namespace markerless_mocap
