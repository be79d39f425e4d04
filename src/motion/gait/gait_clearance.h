#pragma once

#include "motion/gait/gait_path.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Keeps a foot out of the other one. Seen from above a foot is the line from its heel to the tip
/// of its toes, and two such lines stay a shoe's width apart.
class FootClearance {
 public:
  explicit FootClearance(const HumanSkeleton& skeleton);

  /// Metres between the lines of two feet, 0 if they cross.
  double gap(const GroundPose& foot, const GroundPose& other) const;

  /// The place, moved away from the other foot as far as it must.
  GroundPose beside(const GroundPose& place, const GroundPose& other) const;

  /// The shortest detour (see swingPose) by which the left or right foot gets past the other one
  /// that stands, on its own side of it; none if none up to 0.4 m does.
  Eigen::Vector2d detour(bool left, const GroundPose& from, const GroundPose& to,
                         const GroundPose& other) const;

 private:
  double closest(const GroundPose& from, const GroundPose& to, const GroundPose& other,
                 const Eigen::Vector2d& detour) const;

  double heel_x_, toe_x_;  ///< metres from the ankle
  double shoe_width_;      ///< metres
};

}  // namespace markerless_mocap
