#pragma once

#include <ostream>
#include <vector>

#include "tools/offline/offline_run.h"

namespace markerless_mocap {

/// Learns the backgrounds of all cameras from the whole recording, if the options allow it and
/// somebody is there from the first image on; else returns none, and the first images give them.
/// Sets silhouette/background of `pipeline` to first_images, so that the decision is made once.
/// Throws as runOffline().
/// \param notes stream for progress and the result; nullptr: none
/// \param terminal true if `notes` is a terminal
std::vector<SharedBackground> learnBackgrounds(const OfflineOptions& options,
                                               PipelineOptions* pipeline, std::ostream* notes,
                                               bool terminal);

}  // namespace markerless_mocap
