#pragma once

#include "studies/reproduce/fleischmann/fleischmann_film.h"
#include "studies/reproduce/fleischmann/fleischmann_variants.h"

namespace markerless_mocap {

/// Text of config/as_published/fleischmann.yaml.
std::string publishedFleischmannYaml();
/// Options of a YAML text's section pose_fitting/fleischmann with some of them changed. Throws
/// std::invalid_argument as loadPipelineOptions().
FleischmannOptions fleischmannOptions(const std::string& yaml, const Overrides& changes, int seed);

/// Tracks the capture from its true first pose. {"seconds", "D" of each frame, mm, "markers": name
/// to errors of each frame, mm, "poses": parameters of each frame, "lost": frames, "legs_swapped":
/// share of the frames, "seconds_per_frame"}; all without the first frame, whose pose is given. A
/// lost frame counts with the last pose.
Json trackFilm(const Capture& capture, const FilmTruth& truth, const FleischmannVariant& variant,
               int seed);

/// World positions of markerNames().
Eigen::Matrix3Xd markersOf(const FleischmannBodyModel& body_model, const FleischmannVector& v);

}  // namespace markerless_mocap
