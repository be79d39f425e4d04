#pragma once

#include <algorithm>

namespace markerless_mocap {

/// Tells a camera that sends its last image again and again. Images of a sensor differ by their
/// noise; where equal images are usual, as in a rendered or strongly compressed film, it takes
/// twice as many as have been seen before.
class FrozenImages {
 public:
  /// \param is_repeated whether the image is, to the bit, the one before
  /// \return whether the camera is frozen
  bool add(bool is_repeated) {
    if (is_repeated) {
      ++run_;
      return isFrozen();
    }
    if (!isFrozen()) longest_ = std::max(longest_, run_);
    has_changed_ = has_changed_ || ++changes_ >= kMinChanges;
    run_ = 1;
    return false;
  }
  /// Number of equal images, with the last one.
  int run() const { return run_; }

 private:
  static constexpr int kMinChanges = 10;  // before that, nothing is known about the camera
  static constexpr int kMinRun = 3;

  bool isFrozen() const { return has_changed_ && run_ >= std::max(kMinRun, 2 * longest_ + 1); }

  int run_ = 0, longest_ = 1, changes_ = 0;
  bool has_changed_ = false;
};

}  // namespace markerless_mocap
