#pragma once

#include "silhouette/background/background.h"
#include "silhouette/recording/color_candidates.h"
#include "silhouette/recording/person_colors.h"
#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// The background at the samples' size, as far as it shows in the recording.
/// \param person as stillPerson(); empty: nobody keeps still
SceneColors learnSceneColors(const SceneSamples& samples, const cv::Mat& person);

/// The background from a recording in which nobody need ever leave the scene. Pixels whose
/// background is never seen, or may be a person who stands still, are unknown. One mode.
/// \param starts_still nothing moves at first: people are looked for who keep still
Background learnFromRecording(const SceneSamples& samples, bool starts_still);

}  // namespace markerless_mocap
