#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Chapter 6 of Fleischmann 2012 on a walk of the virtual studio that is like the Lee walk.
std::unique_ptr<Paper> makeFleischmannPaper(const ReproduceRequest& request);

/// The captures, at 60 and 20 fps, of this many seconds: four cameras of 644 x 484, a person who
/// walks in a circle, stands still, and walks on; the silhouettes have holes and ragged edges.
std::vector<Capture> fleischmannCaptures(double seconds);

}  // namespace markerless_mocap
