#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "contour/contour_urdf_converter.h"
#include "contour/model/contour_pose.h"
#include "markerless_mocap/tracking/product_source.h"
#include "tracking/pose_initializer.h"

namespace markerless_mocap {

/// Poses that a search for the person begins with: those of the initializer and of the pose tree.
class StartProposals {
 public:
  explicit StartProposals(InitializerFactory make_initializer)
      : make_initializer_(std::move(make_initializer)) {}
  /// Must be called before the others.
  void setBody(const std::shared_ptr<const BodyModel>& model) {
    initializer_ = make_initializer_(model);
  }
  /// The next proposals depend on their frame only.
  void reset() { initializer_->reset(); }
  /// \param converter of the same body
  std::vector<ContourPose> of(int64_t stamp_ns, const FrameProducts& made,
                              const ContourUrdfConverter& converter);
  /// Why the initializer proposed no pose; empty if it did.
  const std::string& initializerError() const { return initializer_error_; }

 private:
  InitializerFactory make_initializer_;
  std::unique_ptr<PoseInitializer> initializer_;
  std::string initializer_error_;
};

}  // namespace markerless_mocap
