#pragma once

#include <string>

#include "markerless_mocap/tracking/body_tracker.h"

namespace markerless_mocap {

/// The URDF of the body on the parameter server, in /human_description_<id>.
class BodyDescription {
 public:
  explicit BodyDescription(const std::string& id) : parameter_("/human_description_" + id) {}
  /// Removes the parameter if it was set here.
  ~BodyDescription();
  BodyDescription(const BodyDescription&) = delete;
  BodyDescription& operator=(const BodyDescription&) = delete;

  void set(const TrackedBody& body);
  /// Sets the parameter again if it was removed.
  void restore();
  void remove();
  /// Asks the master, which has lost it if it was started again. May be called at any time.
  bool isThere() const;
  /// The parameter is not there: restore() will set it.
  void forget();

 private:
  std::string parameter_, urdf_;
  bool set_ = false;
};

}  // namespace markerless_mocap
