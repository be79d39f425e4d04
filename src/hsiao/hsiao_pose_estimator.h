#pragma once

#include <cstdint>
#include <memory>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/products/visual_hull.h"
#include "tracking/pose_initializer.h"

namespace markerless_mocap {

/// Follows one person through time by fitting H's 23-parameter profile to the part curves
/// (Hsiao 2008, 3.2.2): hierarchical swarm, basic against temporal, re-initialisation. The pose is
/// then refined against the hull and must agree with it, or it is lost.
class HsiaoPoseEstimator : public PoseInitializer {
 public:
  /// Throws std::invalid_argument on options out of range or a model that the profile cannot move.
  HsiaoPoseEstimator(std::shared_ptr<const BodyModel> model, const HsiaoOptions& options);
  ~HsiaoPoseEstimator() override;
  /// \param stamp_ns capture time; a stamp not after the last one restarts the track
  BodyPose update(int64_t stamp_ns, const BodyParts& parts, const VisualHull& hull) override;
  void reset() override;
  const BodyModel& model() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace markerless_mocap
