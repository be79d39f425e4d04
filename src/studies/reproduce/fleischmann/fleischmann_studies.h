#pragma once

#include "studies/reproduce/fleischmann/fleischmann_run.h"

namespace markerless_mocap {

/// Fig. 6.19: {"degrees", "silhouette", "edge", "total"} around the true pose of one frame while
/// the forward angle of the right shoulder, x24, varies by its sigma at 20 fps; each term scaled to
/// 0 to 1.
Json fitnessCurves(const Capture& capture, const FilmTruth& truth, size_t frame);

/// Fig. 6.18: {"iterations", and by parameter name the standard deviation over the swarm in each},
/// mean of `frames` frames of a track at 20 fps, relative to the first iteration in which the
/// parameter moves. Fig. 6.17: {"frame", "before", "first_stage", "after": parameters, "scattered":
/// those of the particles that the last stage starts with}, of the last frame.
Json swarmConvergence(const Capture& capture, const FilmTruth& truth, int frames);

/// Table 6.5: seconds of a frame with 1000 evaluations, one thread: {"observing", "kinematics",
/// "drawing_and_silhouette", "edges", "rest"}.
Json timeByPart(const Capture& capture, const FilmTruth& truth);

}  // namespace markerless_mocap
