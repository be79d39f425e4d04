#pragma once

#include "capture/virtual_studio.h"
#include "fleischmann/fleischmann_body_model.h"
#include "fleischmann/fleischmann_motion_statistics.h"

namespace markerless_mocap {

/// F's parameters of the person in a studio, instant by instant.
class TrueParameters {
 public:
  /// Throws as FleischmannBodyModel.
  explicit TrueParameters(const BodyModel& model);
  /// Parameters of the driven body, continuous from call to call.
  const FleischmannVector& follow(const BodyState& body);
  const FleischmannBodyModel& profile() const { return profile_; }

 private:
  const BodyModel& model_;
  FleischmannBodyModel profile_;
  FleischmannVector last_ = FleischmannVector::Zero();
};

/// Motion statistics of people of the studio who do these motions, each once through at 60 frames
/// a second. Throws as VirtualStudio, or std::invalid_argument without motions.
/// \param studio whose motion, rate, rig and image size are replaced
FleischmannMotionStatistics statisticsOf(const std::vector<std::string>& motions,
                                         StudioOptions studio, const StudioFiles& files);

}  // namespace markerless_mocap
