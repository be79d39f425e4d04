#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Proposes poses for a tracker that has none. Not thread-safe.
class PoseInitializer {
 public:
  virtual ~PoseInitializer() = default;
  /// kLost with the reason if it has no proposal. It may build on what it proposed before; after
  /// reset() only on this.
  /// \param stamp_ns capture time, nanoseconds
  virtual BodyPose update(int64_t stamp_ns, const BodyParts& parts, const VisualHull& hull) = 0;
  virtual void reset() = 0;
};

/// Makes one for a body.
using InitializerFactory =
    std::function<std::unique_ptr<PoseInitializer>(std::shared_ptr<const BodyModel> model)>;

}  // namespace markerless_mocap
