#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

namespace markerless_mocap {

/// Decides of which cameras colour images are needed: of those whose masks have, or had a short
/// time ago, an unknown background, or are in doubt.
class ColorDemand {
 public:
  /// \param keep_ns how long images stay needed after the last such mask
  ColorDemand(size_t cameras, int64_t keep_ns) : cameras_(cameras), keep_ns_(keep_ns) {}

  /// A mask has come that needs colours.
  void note(size_t camera, int64_t stamp_ns) { cameras_.at(camera).noted_ns = stamp_ns; }
  /// The camera has no colours: its images are never needed.
  void noteGrey(size_t camera) { cameras_.at(camera).is_grey = true; }
  /// \param stamp_ns of a message of this camera; time may jump
  bool isNeeded(size_t camera, int64_t stamp_ns) const {
    const State& state = cameras_.at(camera);
    return !state.is_grey && state.noted_ns && std::abs(stamp_ns - *state.noted_ns) <= keep_ns_;
  }

 private:
  struct State {
    std::optional<int64_t> noted_ns;  ///< stamp of the last mask that needs colours
    bool is_grey = false;
  };
  std::vector<State> cameras_;
  int64_t keep_ns_;
};

}  // namespace markerless_mocap
