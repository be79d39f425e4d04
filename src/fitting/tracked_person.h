#pragma once

#include <memory>

#include "markerless_mocap/fitting/body_tracker.h"

namespace markerless_mocap {

/// The person as far as known before anything is seen. Throws std::invalid_argument as
/// makeBodyTracker().
std::shared_ptr<const TrackedBody> bodyBeforehand(const TrackerSources& sources, double stature);

/// The person of measured sizes.
std::shared_ptr<const TrackedBody> bodyOfSizes(const TrackerSources& sources,
                                               const ContourSizes& sizes);

}  // namespace markerless_mocap
