#pragma once

#include <memory>
#include <string>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/ros/node_options.h"

namespace markerless_mocap {

/// Text of the URDF template. Throws std::invalid_argument if it cannot be read.
/// \param file empty: the package's own
std::string readUrdfTemplate(const std::string& file);

/// The body's URDF on the parameter server.
class BodyDescription {
 public:
  /// Reads the parameter /human_description_<id>, or sets it from the template. Throws
  /// std::invalid_argument: a parameter that is not set, or as readUrdfTemplate(),
  /// fillUrdfTemplate() and BodyModel::fromUrdf().
  /// \param stature metres
  BodyDescription(const FittingNodeOptions& options, double stature);
  /// Takes back a parameter that it set.
  ~BodyDescription();
  BodyDescription(const BodyDescription&) = delete;
  BodyDescription& operator=(const BodyDescription&) = delete;

  const std::shared_ptr<const BodyModel>& model() const { return model_; }

 private:
  std::string parameter_;
  bool set_here_;
  std::shared_ptr<const BodyModel> model_;
};

}  // namespace markerless_mocap
