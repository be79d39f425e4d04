#pragma once

#include "exports/export_skeleton.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// The bones of a character at the places of a measured body, in the T-pose.
struct MeasuredBones {
  HumanSkeleton skeleton;  ///< heads and tails; the hips' centre is the origin
  PerBone<size_t> joint;   ///< joint of the skeleton that moves the bone
};

/// \param average divides the trunk and the head where the body has one bone
MeasuredBones measuredBones(const ExportSkeleton& skeleton, const HumanSkeleton& average);

}  // namespace markerless_mocap
