#pragma once

#include <Eigen/Geometry>
#include <string>

#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"

/// What a studio does to a clip before it plays it. All but volumeViolation() return the changed
/// clip and throw std::invalid_argument if it has no pose.
namespace markerless_mocap {

/// \param start seconds \param duration seconds, to the end if there is less. Throws
/// std::invalid_argument if the clip ends before `start` or duration is not positive.
MotionClip cut(const MotionClip& clip, double start, double duration);

/// Interpolated at another rate. \param fps frames per second, more than 0, else it throws
MotionClip resampled(const MotionClip& clip, double fps);

/// About the world's z axis. \param yaw radians
MotionClip turned(const MotionClip& clip, double yaw);

/// The middle of the box around the hips' path comes to x = y = 0.
MotionClip centred(const MotionClip& clip);

/// The hips' path wound up on a circle: every step is turned by the distance walked so far over
/// the radius, so steps keep their lengths. \param radius metres, to the left if positive, to the
/// right if negative; throws if less than 0.1 m
MotionClip bent(const MotionClip& clip, double radius);

/// Puts the lower foot on z = 0 whenever the person stands; toes that would reach into the floor
/// bend up, and nothing sinks deeper than some 3 mm. In flight (both feet more than 5 cm above
/// their lowest of half a second before and after) the height is carried over from take-off to
/// landing.
MotionClip onFloor(const MotionClip& clip, const HumanSkeleton& skeleton);

/// Height of the lowest point of the soles: heel, ball and toe tip of each foot, which are on z = 0
/// in the T-pose.
double soleHeight(const HumanSkeleton& skeleton, const HumanPose& pose);

/// Repeated until it lasts `duration` seconds; a longer clip is returned as it is. The repeated
/// part is the one whose ends are the most alike; where they differ the poses are bridged within
/// a fraction of a second, eased. Each repetition goes on from where and whither the last one led.
MotionClip extended(const MotionClip& clip, double duration);

/// Whether head, wrists, elbows, ankles or tips leave a box in the world. Empty if not; else
/// a sentence with the greatest excess: "the motion reaches x = 2.9 m at 1.2 s, the volume ends at
/// 2.0 m; shorten, centre or bend it".
std::string volumeViolation(const MotionClip& clip, const HumanSkeleton& skeleton,
                            const Eigen::AlignedBox3d& volume);

}  // namespace markerless_mocap
