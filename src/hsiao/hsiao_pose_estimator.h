#pragma once

#include <cstdint>
#include <memory>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/products/visual_hull.h"
#include "tracking/pose_initializer.h"

namespace markerless_mocap {

/// Tracks one person by fitting Hsiao's model with 23 parameters to the part curves (Hsiao 2008,
/// 3.2.2): hierarchical PSO, comparison of basic and temporal PSO, re-initialisation. If the
/// hull is used (not in the thesis), the pose is refined with it and is lost if it disagrees.
class HsiaoPoseEstimator : public PoseInitializer {
 public:
  /// Throws std::invalid_argument if an option is out of range, or if a joint of the model does not
  /// suit Hsiao's parameters.
  HsiaoPoseEstimator(std::shared_ptr<const BodyModel> model, const HsiaoOptions& options);
  ~HsiaoPoseEstimator() override;
  /// \param stamp_ns capture time; a stamp that is not later than the last one restarts the
  ///   tracking
  BodyPose update(int64_t stamp_ns, const BodyParts& parts, const VisualHull& hull) override;
  void reset() override;
  const BodyModel& model() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace markerless_mocap
