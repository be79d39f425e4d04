#pragma once

#include "camera/film_clocks.h"
#include "checks/motion/rig_model.h"

namespace markerless_mocap {

/// Searches the offsets with which all cameras see the person in one place, wide and coarse, then
/// fine. \param model the cameras; their own offsets and drifts are not used \param largest offset
/// between two cameras, s. \return as FilmClocks; the camera that sees most of the person has 0
FilmClocks searchPersonClocks(const std::vector<PersonTrack>& tracks, const RigModel& model,
                              double largest);

}  // namespace markerless_mocap
