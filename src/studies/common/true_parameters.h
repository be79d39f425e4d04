#pragma once

#include "capture/virtual_studio.h"
#include "fleischmann/fleischmann_body_model.h"
#include "fleischmann/fleischmann_motion_statistics.h"

namespace markerless_mocap {

/// Fleischmann's parameters of the person in a virtual studio, frame by frame.
class TrueParameters {
 public:
  /// Throws as FleischmannBodyModel.
  explicit TrueParameters(const BodyModel& model);
  /// Parameters of the body, continuous from call to call.
  const FleischmannVector& follow(const BodyState& body);
  const FleischmannBodyModel& bodyModel() const { return body_model_; }

 private:
  const BodyModel& model_;
  FleischmannBodyModel body_model_;
  FleischmannVector last_ = FleischmannVector::Zero();
};

/// Motion statistics of people in the studio who perform these motions once, at 60 frames per
/// second. Throws as VirtualStudio, and std::invalid_argument without motions.
/// \param studio options; motion, rate, rig and image size are replaced
FleischmannMotionStatistics statisticsOf(const std::vector<std::string>& motions,
                                         StudioOptions studio, const StudioFiles& files);

}  // namespace markerless_mocap
