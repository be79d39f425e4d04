#pragma once

#include "skeleton/graph/tree_graph.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

/// Opens loops at the hands. If an arm forms a loop with the trunk (hand on the hip, arm at the
/// side), the shortest paths from the head meet somewhere on the forearm. The arm is extended to
/// its full length, and the loop is opened there.
void openLoopsAtHands(const TreeGraph& graph, LabelChoice* choice);

}  // namespace markerless_mocap
