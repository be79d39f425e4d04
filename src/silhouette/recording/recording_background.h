#pragma once

#include "silhouette/background/background.h"
#include "silhouette/recording/color_candidates.h"
#include "silhouette/recording/person_colors.h"
#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// The background at the samples' size, as far as it shows in the recording.
SceneColors learnSceneColors(const SceneSamples& samples);

/// The background from a recording in which nobody need ever leave the scene. Pixels whose
/// background is never seen, or may be a person who stands still, are unknown. One mode.
Background learnFromRecording(const SceneSamples& samples);

}  // namespace markerless_mocap
