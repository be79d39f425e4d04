#pragma once

#include <memory>
#include <string>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Text of the URDF template. Throws std::invalid_argument if it cannot be read.
/// \param file empty: the package's own
std::string readUrdfTemplate(const std::string& file);

/// The body's URDF on the parameter server.
class BodyDescription {
 public:
  /// Takes the URDF of the parameter /human_description_<id> if there is one; otherwise fills the
  /// template and sets the parameter. Throws std::invalid_argument as readUrdfTemplate(),
  /// fillUrdfTemplate() and BodyModel::fromUrdf().
  /// \param stature metres
  BodyDescription(const std::string& id, const std::string& template_file, double stature);
  /// Takes back a parameter that it set.
  ~BodyDescription();
  BodyDescription(const BodyDescription&) = delete;
  BodyDescription& operator=(const BodyDescription&) = delete;

  const std::shared_ptr<const BodyModel>& model() const { return model_; }

 private:
  std::string parameter_;
  bool set_here_ = false;
  std::shared_ptr<const BodyModel> model_;
};

}  // namespace markerless_mocap
