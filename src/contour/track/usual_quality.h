#pragma once

namespace markerless_mocap {

/// The quality of the fits of one body in one room, qualityOf(ContourFit). It varies little from
/// frame to frame, and a limb in a wrong place lowers it by more than that.
class UsualQuality {
 public:
  void forget() { *this = UsualQuality(); }
  /// Of a frame that nothing has disturbed.
  void add(double quality);
  /// False if the quality is lower than chance makes it; true as long as few have been added.
  bool includes(double quality) const;

 private:
  int count_ = 0;
  double mean_ = 0.0, variance_ = 0.0;  ///< of the last few seconds
};

}  // namespace markerless_mocap
