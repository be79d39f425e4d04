#pragma once

#include "fleischmann/fleischmann_profile.h"
#include "capture/virtual_studio.h"
#include "fleischmann/motion_statistics.h"

namespace markerless_mocap {

/// F's parameters of the person in a studio, instant by instant.
class TrueParameters {
 public:
  /// Throws as FleischmannProfile.
  explicit TrueParameters(const BodyModel& model);
  /// Parameters of the driven body, continuous from call to call.
  const FleischmannVector& follow(const BodyState& body);
  const FleischmannProfile& profile() const { return profile_; }

 private:
  const BodyModel& model_;
  FleischmannProfile profile_;
  FleischmannVector last_ = FleischmannVector::Zero();
};

/// Motion statistics of people of the studio who do these motions, each once through at 60 frames
/// a second. Throws as VirtualStudio, or std::invalid_argument without motions.
/// \param studio whose motion, rate, rig and image size are replaced
MotionStatistics statisticsOf(const std::vector<std::string>& motions, StudioOptions studio,
                              const StudioFiles& files);

}  // namespace markerless_mocap
