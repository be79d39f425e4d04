#pragma once

#include "skeleton/labelling/label_choice.h"
#include "skeleton/labelling/label_ends.h"

namespace markerless_mocap {

/// Five ends that may be a body's.
struct EndNames {
  std::array<int, kLimbEndCount> ends{-1, -1, -1, -1, -1};  ///< by LimbEnd; the feet may share one
  double probability = 0.0;                                 ///< that they are, by the fitted model
};

/// Names ends by how likely a body has such ways between its ends, such thicknesses and heights: a
/// log-linear model over all choices of five ends, fitted to people of the virtual studio. The
/// probability counts choices whose ends lie within `same` metres as one. Ends of -1: there is no
/// choice with a body's measures.
EndNames nameEnds(const SkeletonEnds& ends, const TreeGraph& graph, double same);

/// The ends that may be a body's.
SkeletonEnds candidateEnds(const TreeGraph& graph, const TreeVolume& volume);

/// Labels a graph so. \param probability as in EndNames
LabelChoice labelByTemplate(const TreeGraph& graph, const TreeVolume& volume, double* probability);

}  // namespace markerless_mocap
