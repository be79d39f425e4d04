#pragma once

#include <functional>

#include "evaluation/joint_track.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// The true labelTruthNames() of a capture.
JointTrack labelTruth(const Capture& capture);

/// One frame of a track.
JointTrack frameOf(const JointTrack& truth, size_t frame);

/// The published options, config/as_published/bakken.yaml. Throws std::invalid_argument as
/// loadPipelineOptions().
/// \param edge voxels along an edge of the cube, 64 or 128
PipelineOptions publishedBakkenOptions(int edge);

/// The published options of the hull with the cube in the middle of a person's track.
HullOptions cubeAround(const JointTrack& truth, HullOptions options);

/// Calls a function with the exact silhouettes of each frame that shows the person.
/// \param visit gets the number of the frame in the truth
void forEachFrame(const Capture& capture, const JointTrack& truth,
                  const std::function<void(size_t frame, const std::vector<HullView>&)>& visit);

/// The cameras of a capture.
CameraRig rigOf(const Capture& capture);

}  // namespace markerless_mocap
