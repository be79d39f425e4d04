#pragma once

#include <optional>
#include <vector>

#include "contour/track/pose_history.h"

namespace markerless_mocap {

/// A frame and who is looked for in it.
struct FittedFrame {
  const ContourObservation& seen;
  const ContourBody& body;
};

/// Other poses than the one that was fitted: other places of limbs, the last pose, exchanged legs,
/// a straight trunk. Functions that take a fit by pointer replace it if a rival is clearly better,
/// and return whether one was. Immutable.
class RivalPoses {
 public:
  /// Throws std::invalid_argument if an option is out of range.
  RivalPoses(const CameraRig& rig, const ContourOptions& options);
  const ContourFitter& fitter() const { return fitter_; }

  /// The best fit from a pose that may be wrong by tenths of a radian and decimetres. Other
  /// positions of its limbs are tried, too.
  ContourFit search(const FittedFrame& now, const ContourPose& pose) const;
  /// Another place of one limb that fits better; empty if there is none. \param pose a fitted one
  std::optional<ContourPose> searchLimb(const FittedFrame& now, const ContourPose& pose,
                                        ContourLimb::Id limb) const;

  /// Tries the last pose and, after a long step, exchanged legs.
  bool tryLastPose(const FittedFrame& now, const PoseHistory& history,
                   const ContourPrediction& prediction, ContourFit* fit) const;
  /// Searches one limb around its predicted place.
  bool searchLimbNear(const FittedFrame& now, ContourLimb::Id limb,
                      const ContourPrediction& prediction, ContourFit* fit) const;
  /// Searches the limb that contours determine least, unless they determine all.
  bool searchLeastCertainLimb(const FittedFrame& now, const ContourPrediction& prediction,
                              ContourFit* fit) const;
  /// If the trunk is twisted, tries the pose without the twist.
  bool untwist(const FittedFrame& now, const ContourPrediction& prediction, ContourFit* fit) const;

 private:
  bool tryPoses(const FittedFrame& now, const std::vector<ContourPose>& starts,
                const std::optional<ContourPrediction>& prediction, double gain,
                ContourFit* fit) const;
  /// Tries other places of a limb around the expected pose.
  bool tryLimb(const FittedFrame& now, ContourLimb::Id limb, const ContourPose& expected,
               const std::optional<ContourPrediction>& prediction, ContourFit* fit) const;

  CameraRig rig_;
  ContourFitter fitter_;
};

}  // namespace markerless_mocap
