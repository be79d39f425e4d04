#pragma once

#include <string>
#include <vector>

#include "hull/voting/voting_booth.h"

namespace markerless_mocap {

/// What is remarkable about the masks of the present cameras.
struct MaskSurvey {
  CameraSet present = 0, empty = 0, full = 0;

  int count() const { return __builtin_popcount(present); }
};

MaskSurvey surveyMasks(const CameraRig& rig, const VotingBooth& booth);

/// 'a', 'b'
std::string namesOf(CameraSet cameras, const CameraRig& rig);

/// Sets status and reason, and returns true, where the masks alone tell that there is nothing to
/// carve. \param usable cameras whose masks can be carved with
bool refuseMasks(const MaskSurvey& masks, CameraSet usable, const CameraRig& rig, int min_views,
                 VisualHull* hull);

/// Measures the pieces, puts poorly seen ones and suspects behind the others, and fills
/// `components`.
std::vector<Piece> rankPieces(std::vector<Piece> pieces, const CarvingPlan& plan, CameraSet voters,
                              double min_component_litres, VisualHull* hull);

/// Chooses the person, the first of ranked pieces, and sets status and reason; nullptr unless the
/// status is kOk.
const Piece* selectPerson(const std::vector<Piece>& pieces, double min_component_litres,
                          const MaskSurvey& masks, const CameraRig& rig, VisualHull* hull);

}  // namespace markerless_mocap
