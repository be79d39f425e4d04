#pragma once

#include <string>
#include <vector>

#include "hull/voting/voxel_voting.h"

namespace markerless_mocap {

/// Which masks are present, empty or full.
struct MaskSummary {
  CameraSet present = 0, empty = 0, full = 0;

  int count() const { return __builtin_popcount(present); }
};

MaskSummary summariseMasks(const CameraRig& rig, const VoxelVoting& voting);

/// 'a', 'b'
std::string namesOf(CameraSet cameras, const CameraRig& rig);

/// Sets status and reason and returns true if the masks alone show that there is nothing to carve.
/// \param usable cameras whose masks can be carved with
bool rejectMasks(const MaskSummary& masks, CameraSet usable, const CameraRig& rig, int min_views,
                 VisualHull* hull);

/// Measures the components, moves poorly seen and unsure ones and suspected ghosts behind the
/// others, and fills the hull's `components`.
std::vector<VoxelComponent> rankComponents(std::vector<VoxelComponent> components,
                                           const ProjectionTable& table, CameraSet voters,
                                           double min_component_litres, VisualHull* hull);

/// Selects the person, the first of the ranked components, and sets status and reason. Of several
/// bodies it is the one that is where the last person was. Returns nullptr unless the status is
/// kOk. \param last the last person; null if there was none
const VoxelComponent* selectPerson(const std::vector<VoxelComponent>& components,
                                   double min_component_litres, const MaskSummary& masks,
                                   const CameraRig& rig, const VoxelComponent* last,
                                   VisualHull* hull);

}  // namespace markerless_mocap
