#pragma once

#include "skeleton/labelling/extremity_candidates.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

struct ExtremityLabelModel;

/// Five ends that may be a body's.
struct ExtremityLabels {
  std::array<int, kUnsidedExtremityCount> extremities{
      -1, -1, -1, -1, -1};   ///< by UnsidedExtremity; the feet may share one
  double probability = 0.0;  ///< that they are, by the fitted model
};

/// Names ends by how likely a body has such ways between its ends, such thicknesses and heights: a
/// log-linear model over all choices of five ends, fitted to people of the virtual studio. The
/// probability counts choices whose ends lie within `same` metres as one. Ends of -1: there is no
/// choice with a body's measures.
ExtremityLabels labelExtremities(const ExtremityCandidates& ends, const TreeGraph& graph,
                                 const ExtremityLabelModel& model, double same);

/// The ends that may be a body's.
ExtremityCandidates extremityCandidates(const TreeGraph& graph, const TreeVolume& volume);

/// Labels a graph so. \param probability as in ExtremityLabels
LabelChoice labelByTemplate(const TreeGraph& graph, const TreeVolume& volume,
                            const ExtremityLabelModel& model, double* probability);

}  // namespace markerless_mocap
