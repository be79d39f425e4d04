#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Proposes poses to a tracker that has none. Not thread-safe.
class PoseInitializer {
 public:
  virtual ~PoseInitializer() = default;
  /// A proposed pose; kLost with the reason if there is none. The proposal may depend on earlier
  /// calls since the last reset().
  /// \param stamp_ns capture time, nanoseconds
  virtual BodyPose update(int64_t stamp_ns, const BodyParts& parts, const VisualHull& hull) = 0;
  virtual void reset() = 0;
};

/// Makes an initializer for a body.
using InitializerFactory =
    std::function<std::unique_ptr<PoseInitializer>(std::shared_ptr<const BodyModel> model)>;

}  // namespace markerless_mocap
