#pragma once

#include <vector>

#include "motion/human_pose.h"

namespace markerless_mocap {

/// A sampled motion.
struct MotionClip {
  double fps = 0.0;
  std::vector<HumanPose> poses;  ///< pose i is at i / fps seconds

  /// Seconds from the first to the last pose.
  double duration() const { return poses.empty() ? 0.0 : (poses.size() - 1) / fps; }
  /// The interpolated pose at a time; before the beginning the first pose, after the end the last.
  /// Throws std::invalid_argument if there is no pose.
  HumanPose at(double seconds) const;
};

}  // namespace markerless_mocap
