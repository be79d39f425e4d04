#pragma once

#include "motion/gait/gait_path.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Keeps the feet apart. From above a foot is the line from its heel to the tip of its toes, and
/// two such lines stay a shoe's width apart.
class FootClearance {
 public:
  explicit FootClearance(const HumanSkeleton& skeleton);

  /// Distance between the lines of two feet, metres; 0 if they cross.
  double gap(const GroundPose& foot, const GroundPose& other) const;

  /// The position, moved away from the other foot as far as needed.
  GroundPose beside(const GroundPose& place, const GroundPose& other) const;

  /// The shortest detour (see swingPose()) by which a foot passes the other, standing foot on its
  /// own side; zero if no detour up to 0.4 m is enough.
  Eigen::Vector2d detour(bool left, const GroundPose& from, const GroundPose& to,
                         const GroundPose& other) const;

 private:
  double closest(const GroundPose& from, const GroundPose& to, const GroundPose& other,
                 const Eigen::Vector2d& detour) const;

  double heel_x_, toe_x_;  ///< relative to the ankle, metres
  double shoe_width_;      ///< metres
};

}  // namespace markerless_mocap
