#pragma once

#include <string>

#include "capture/studio_options.h"
#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"

namespace markerless_mocap {

/// The motion that the options name for a person of this size, cut, bent and prolonged as they say.
/// A BVH motion is put on the floor, its middle in the centre.
/// \param folder where the package's own motions are
/// Throws std::invalid_argument with one sentence: there is no such motion, its file's faults, or
/// it leaves the stage.
MotionClip loadMotion(const StudioOptions& options, const std::string& folder,
                      const HumanSkeleton& skeleton);

/// A motion that goes on for ever: after its end the person glides back to where it began, unless
/// that is where it ends, and starts over.
class LoopedMotion {
 public:
  explicit LoopedMotion(MotionClip clip);
  /// \param seconds any
  HumanPose at(double seconds) const;
  double duration() const { return clip_.duration(); }
  /// From one beginning to the next, s.
  double period() const { return clip_.duration() + return_seconds_; }

 private:
  MotionClip clip_;
  double return_seconds_;
};

}  // namespace markerless_mocap
