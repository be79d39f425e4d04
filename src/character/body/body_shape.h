#pragma once

#include <Eigen/Core>

#include "character/body/body_measures.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Signed distances to the parts of the left half of a body, metres.
struct PartDistances {
  double torso;  ///< with shoulders, breasts and buttocks
  double arm;    ///< shoulder to wrist
  double hand;
  double leg;  ///< hip to ankle
  double foot;
  double head;  ///< with the neck
};

/// The body without clothes in the T-pose of a skeleton, as a signed distance. Left and right are
/// mirrored: it is evaluated for points with y >= 0 only.
class BodyShape {
 public:
  BodyShape(const HumanSkeleton& skeleton, const BodyBuild& build);

  PartDistances parts(const Eigen::Vector3d& p) const;
  // Smooth unions of parts.
  double torsoAndArm(const PartDistances& parts) const;
  double torsoAndLeg(const PartDistances& parts) const;
  double whole(const PartDistances& parts) const;

  const HumanSkeleton& skeleton() const { return skeleton_; }
  const BodyBuild& build() const { return build_; }

 private:
  double torso(const Eigen::Vector3d& p) const;
  double head(const Eigen::Vector3d& p) const;
  double hand(const Eigen::Vector3d& from_wrist) const;
  double scaled(double man) const { return man * build_.stature / 1.75; }

  HumanSkeleton skeleton_;
  BodyBuild build_;
  Loft torso_, neck_, head_, leg_, arm_, hand_, foot_;
};

}  // namespace markerless_mocap
