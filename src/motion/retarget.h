#pragma once

#include <string>

#include "motion/bvh.h"
#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"

namespace markerless_mocap {

/// Transfers a motion to another person. Limbs have the directions of the file; legs with other
/// proportions bend so that the ankles keep their scaled positions relative to the hip joints, so
/// standing feet do not slide. Trunk, neck and head rotate from their rest as in the file. A chain
/// of spine joints is distributed over spine and chest. The hips' path is scaled by the ratio of
/// leg lengths, which also removes the file's unit.
///
/// Up and forward are found from the rest pose, or from the first frame if the rest pose is no
/// standing person: z is up, and a person in the orientation of the rest pose faces +x. A T-pose
/// before the motion is left out. Standing feet are levelled, see levelFeet(). The height is that
/// of the file; for the floor see onFloor().
/// \param file name for error messages
/// Throws std::invalid_argument if bones are missing (mapBones()), or if neither the rest pose nor
/// the first frame is an upright person.
MotionClip retarget(const BvhMotion& motion, const HumanSkeleton& skeleton,
                    const std::string& file);

/// Rotates each foot and its toes by one constant angle, so that the sole is flat in the median
/// over the frames in which the ball of the foot rests low.
void levelFeet(MotionClip& clip, const HumanSkeleton& skeleton);

}  // namespace markerless_mocap
