#pragma once

#include <vector>

#include "hull/selection/voxel_component.h"
#include "hull/voting/projection_table.h"
#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// Where the background is not known, masks meet whether somebody is there or not, as at the place
/// where somebody stood while it was learned. Sets `unsure` of each component that hardly any
/// camera sees a person in, compared with another one that may be a body. Only the first eight are
/// judged.
/// \param views one per camera; their masks are valid for voters
void markUnsure(const ProjectionTable& table, CameraSet voters, const std::vector<HullView>& views,
                std::vector<VoxelComponent>* components);

}  // namespace markerless_mocap
