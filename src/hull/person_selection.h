#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// What is remarkable about the masks of the present cameras.
struct MaskSurvey {
  size_t present = 0;
  size_t empty = 0;
  std::vector<size_t> set_pixels;  ///< per camera, 0 where missing
  std::string empty_names;         ///< 'a', 'b'
  std::string full_names;
};

MaskSurvey surveyMasks(const CameraRig& rig, const std::vector<HullView>& views);

/// Sets status and reason, and returns true, where the masks alone tell that there is nothing to
/// carve.
bool refuseMasks(const MaskSurvey& masks, int min_views, VisualHull* hull);

/// Chooses the person among components in descending order, and fills status, reason and
/// component_litres. Empty unless the status is kOk.
std::vector<uint32_t> selectPerson(std::vector<std::vector<uint32_t>> components,
                                   const HullOptions& options, const MaskSurvey& masks,
                                   VisualHull* hull);

}  // namespace markerless_mocap
