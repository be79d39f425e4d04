#pragma once

#include <string>

#include "motion/bvh.h"
#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"

namespace markerless_mocap {

/// The motion played by another person. Limbs point as in the file, but legs whose knees are
/// elsewhere bend so that the ankles keep their scaled places below the hip joints, and standing
/// feet do not slide; trunk, neck and head turn from their rest as in the file; a chain of spine
/// joints is spread over spine and chest. The hips' path is scaled by the ratio of leg lengths,
/// which also settles the file's unit. Up and forward are found from the rest pose (or, if that is
/// no standing person, the first frame): z is up, and a person turned as in the rest pose faces +x.
/// A T-pose in front of the motion is left out. Feet that stand are levelled, see levelFeet().
/// Height is as in the file: for the floor see onFloor(). \param file named in faults Throws
/// std::invalid_argument if bones are missing (mapBones()) or nobody stands upright in rest pose or
/// first frame.
MotionClip retarget(const BvhMotion& motion, const HumanSkeleton& skeleton,
                    const std::string& file);

/// Turns each foot and its toes by one constant angle so that, in the median over the instants when
/// the ball of the foot rests low, the sole is flat.
void levelFeet(MotionClip& clip, const HumanSkeleton& skeleton);

}  // namespace markerless_mocap
