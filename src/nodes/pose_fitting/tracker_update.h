#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "nodes/pose_fitting/fitting_inputs.h"

namespace markerless_mocap {

/// A camera's mask; empty if there is none that can be used.
cv::Mat maskOrNothing(const FittingMessages& input, size_t camera);

/// The joint centres of a pose that is not lost, m in world.
std::vector<Eigen::Vector3d> jointsOf(const BodyModel& model, const BodyPose& pose);

/// The messages without those of cameras that are elsewhere than the tracker's rig has them.
FittingMessages withoutChangedCameras(FittingMessages input, const CameraRig& rig);

/// Updates a tracker with messages. A mask that cannot be used is left out; if none can, or if
/// another message cannot be used, this throws std::invalid_argument. \param stamp_ns the tracker's
/// time \param images_required if not, images that cannot be read are left out \param report called
/// with the pose as soon as it is known, unless it is empty
BodyPose updated(BodyTracker& tracker, const FittingMessages& input, LiveProducts& products,
                 int64_t stamp_ns, bool images_required,
                 const std::function<void(const BodyPose&)>& report = {});

}  // namespace markerless_mocap
