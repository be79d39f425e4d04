#pragma once

#include <memory>

#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_sources.h"

namespace markerless_mocap {

/// The person as far as known before anything is seen. Throws std::invalid_argument as
/// makeBodyTracker().
std::shared_ptr<const TrackedBody> bodyBeforehand(const PersonSources& sources, double stature);

/// The person of measured sizes.
std::shared_ptr<const TrackedBody> bodyOfSizes(const PersonSources& sources,
                                               const ContourSizes& sizes);

}  // namespace markerless_mocap
