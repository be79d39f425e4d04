#pragma once

#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// The views without the masks of those cameras that know too little of their background: every
/// unknown pixel may be person, so that such a camera carves nothing and only blurs the votes of
/// the others.
/// \param left_out receives these cameras and the reason
std::vector<HullView> withoutUnknownViews(std::vector<HullView> views, const CameraRig& rig,
                                          std::vector<LeftOutCamera>* left_out);

}  // namespace markerless_mocap
