#pragma once

#include <Eigen/Geometry>

namespace markerless_mocap {

/// The middle joint and the far end of a limb of two bones.
struct TwoBoneIkResult {
  Eigen::Vector3d middle;
  Eigen::Vector3d end;  ///< the target, or what the limb reaches of it
};

/// Bends a limb of two bones so that its end comes to the target, or on the line to it as far as
/// it reaches. The middle joint points to `pole` as well as it can. \param upper, lower lengths in
/// metres \param max_bend of the middle joint, radians
TwoBoneIkResult solveTwoBoneIk(const Eigen::Vector3d& root, const Eigen::Vector3d& target,
                               double upper, double lower, const Eigen::Vector3d& pole,
                               double max_bend);

/// Where a limb's end should go if it is wanted at `target`: up to 0.99 of the limb's length there,
/// beyond it yields ever more and never quite straightens the limb, whose middle joint would
/// otherwise snap. \param length of both bones, metres
Eigen::Vector3d softIkTarget(const Eigen::Vector3d& root, const Eigen::Vector3d& target,
                             double length);

/// The rotation that turns direction `from` into `to` and the hinge `hinge_from` into `hinge_to`
/// as well as it can.
Eigen::Quaterniond turnWithHinge(const Eigen::Vector3d& from, const Eigen::Vector3d& hinge_from,
                                 const Eigen::Vector3d& to, const Eigen::Vector3d& hinge_to);

}  // namespace markerless_mocap
