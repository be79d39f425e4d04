#pragma once

#include <cstdint>
#include <optional>

namespace markerless_mocap {

/// The quality of the fits of one body in one room, ContourFit::majority_quality. It varies little
/// from frame to frame, and a limb in a wrong place lowers it by more than that.
class UsualQuality {
 public:
  void forget() { *this = UsualQuality(); }
  /// Of a frame that nothing has disturbed.
  void add(double quality);
  /// False if the quality is lower than chance makes it; true as long as few have been added.
  bool includes(double quality) const;
  /// False if the quality is lower than that by as much as another place of a limb makes it.
  bool isNear(double quality) const;
  /// True if the quality of a frame is so low that something is wrong. If it stays so low for some
  /// seconds, nothing is usual any more.
  bool isFarAbove(int64_t stamp_ns, double quality);

 private:
  int count_ = 0;
  double mean_ = 0.0, variance_ = 0.0;  ///< of the last few seconds
  std::optional<int64_t> far_above_since_ns_;
};

}  // namespace markerless_mocap
