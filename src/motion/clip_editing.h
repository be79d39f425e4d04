#pragma once

#include <Eigen/Geometry>
#include <string>

#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"

/// Operations on clips. The functions that return a clip throw std::invalid_argument if the given
/// clip has no pose.
namespace markerless_mocap {

/// \param start seconds
/// \param duration seconds; to the end if the clip is shorter
/// Throws std::invalid_argument if the clip ends before `start` or the duration is not positive.
MotionClip cut(const MotionClip& clip, double start, double duration);

/// Turns the motion about the world's z axis.
/// \param yaw radians
MotionClip turned(const MotionClip& clip, double yaw);

/// Moves the centre of the bounding box of the hips' path to x = y = 0.
MotionClip centred(const MotionClip& clip);

/// Bends the hips' path to a circle. Each step is turned by the distance walked so far divided by
/// the radius, so steps keep their lengths.
/// \param radius metres, to the left if positive, to the right if negative; throws if its magnitude
///   is less than 0.1 m
MotionClip bent(const MotionClip& clip, double radius);

/// Puts the lower foot on z = 0 while the person stands. Toes that would penetrate the floor are
/// bent up, and no point is more than about 3 mm below the floor. In flight (both feet more than 5
/// cm above their minimum within half a second) the height is interpolated from take-off to
/// landing.
MotionClip onFloor(const MotionClip& clip, const HumanSkeleton& skeleton);

/// Height of the lowest point of the soles, metres: heel, ball and toe tip of each foot, which are
/// on z = 0 in the T-pose.
double soleHeight(const HumanSkeleton& skeleton, const HumanPose& pose);

/// Repeats a clip until it lasts `duration` seconds; a longer clip is returned unchanged. The
/// repeated part is the one whose ends are most similar. Where they differ, the poses are
/// interpolated smoothly within a fraction of a second. Each repetition continues from the position
/// and heading at the end of the last one.
MotionClip extended(const MotionClip& clip, double duration);

/// Checks whether head, wrists, elbows, ankles and tips stay inside a box in the world. Empty if
/// they do; else a message with the largest violation, for example "the motion reaches x = 2.9 m at
/// 1.2 s, the volume ends at 2.0 m; shorten, centre or bend it".
std::string volumeViolation(const MotionClip& clip, const HumanSkeleton& skeleton,
                            const Eigen::AlignedBox3d& volume);

}  // namespace markerless_mocap
