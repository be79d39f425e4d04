#pragma once

#include <string>

#include "capture/studio_options.h"
#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"

namespace markerless_mocap {

/// The motion of the options for a person of this size, cut, bent and extended as they say. A BVH
/// motion is put on the floor and centred.
/// \param folder folder of the package's own motions
/// Throws std::invalid_argument if there is no such motion, its file has an error, or it leaves the
/// capture volume.
MotionClip loadMotion(const StudioOptions& options, const std::string& folder,
                      const HumanSkeleton& skeleton);

/// A motion that repeats without end. After its end the person glides back to the start, unless the
/// motion ends there, and starts again.
class LoopedMotion {
 public:
  explicit LoopedMotion(MotionClip clip);
  /// \param seconds any time
  HumanPose at(double seconds) const;
  double duration() const { return clip_.duration(); }
  /// Time from one start to the next, s.
  double period() const { return clip_.duration() + return_seconds_; }

 private:
  MotionClip clip_;
  double return_seconds_;
};

}  // namespace markerless_mocap
