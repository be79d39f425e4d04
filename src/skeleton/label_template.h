#pragma once

#include "skeleton/labelling/extremity_candidates.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

struct ExtremityLabelModel;

/// Five ends that may be the extremities of a body.
struct ExtremityLabels {
  std::array<int, kUnsidedExtremityCount> extremities{
      -1, -1, -1, -1, -1};   ///< indices of candidates, by UnsidedExtremity; the feet may share one
  double probability = 0.0;  ///< that they are, by the learned model
};

/// Labels extremities by the likelihood of their path lengths, thicknesses and heights: a
/// log-linear model over all choices of five ends, learned from people of the virtual studio.
/// Choices whose ends lie within `same` metres count as one in the probability. If no choice has
/// the measures of a body, all extremities are -1.
ExtremityLabels labelExtremities(const ExtremityCandidates& ends, const TreeGraph& graph,
                                 const ExtremityLabelModel& model, double same);

/// Candidates for the extremities of a body.
ExtremityCandidates extremityCandidates(const TreeGraph& graph, const TreeVolume& volume);

/// Labels the extremities of a graph by labelExtremities().
/// \param probability output, as in ExtremityLabels
LabelChoice labelByTemplate(const TreeGraph& graph, const TreeVolume& volume,
                            const ExtremityLabelModel& model, double* probability);

}  // namespace markerless_mocap
