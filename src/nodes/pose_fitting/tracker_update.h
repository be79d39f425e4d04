#pragma once

#include <string>

#include "markerless_mocap/tracking/body_tracker.h"
#include "nodes/pose_fitting/fitting_inputs.h"

namespace markerless_mocap {

/// The messages without those of cameras that are elsewhere than the tracker's rig has them.
FittingMessages withoutChangedCameras(FittingMessages input, const CameraRig& rig);

/// Updates a tracker with messages. A mask that cannot be used is left out; if none can, or if
/// another message cannot be used, this throws std::invalid_argument. \param stamp_ns the tracker's
/// time \param images_required if not, images that cannot be read are left out
BodyPose updated(BodyTracker& tracker, const FittingMessages& input, LiveProducts& products,
                 int64_t stamp_ns, bool images_required);

}  // namespace markerless_mocap
