#pragma once

#include "skeleton/graph/tree_graph.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

/// Where an arm closes a loop with the trunk (hand on the hip, arm at the side), the shortest paths
/// from the head meet somewhere on the forearm. Lets the arm go on to its full length and opens the
/// loop there.
void openLoopsAtHands(const TreeGraph& graph, LabelChoice* choice);

}  // namespace markerless_mocap
