#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Cameras of which too little is known to use them. The others wait for them for a while, then go
/// without them until more is known.
class LackingCameras {
 public:
  /// \param required that many cameras are enough
  LackingCameras(std::vector<std::string> cameras, size_t required)
      : cameras_(std::move(cameras)), required_(required), is_left_out_(cameras_.size(), false) {}

  /// Returns whether other cameras than before are left out.
  /// \param lacks by camera: what is not known; empty: it can be used
  /// \param now s, by a clock that is never set
  /// \param remarks a sentence is appended for each camera that is left out or comes back
  bool settle(const std::vector<std::string>& lacks, double now, std::vector<std::string>* remarks);
  bool isLeftOut(size_t camera) const { return is_left_out_.at(camera); }

 private:
  std::vector<std::string> cameras_;
  size_t required_;
  std::vector<bool> is_left_out_;
  std::optional<double> waiting_since_;  ///< s; enough cameras are known since
};

}  // namespace markerless_mocap
