#pragma once

#include <Eigen/Core>

#include "skeleton/graph/tree_volume.h"
#include "skeleton/labelling/label_choice.h"
#include "skeleton/labelling/left_right.h"

namespace markerless_mocap {

/// Position of knuckles, ball of the foot or centre of the head, world metres, from the path of a
/// limb. The path is extended to the surface; the point lies before the surface by a fraction of
/// the body's size. The fractions are means over people of the virtual studio;
/// `scripts/fit_pose_tree shares` measures such means.
/// \param path from the extremity upwards, at least one point, world metres
/// \param closed whether the extremity touches the body; then the path is as long as the limb and
///   is not extended
/// \param longest longest path, the unit of the proportions, metres
Eigen::Vector3d extremityPosition(const NodePath& path, UnsidedExtremity end, bool closed,
                                  double longest, const TreeVolume& volume);

/// Positions of the balls of two feet that share one extremity, to the left and right of its
/// centre, world metres.
std::array<Eigen::Vector3d, 2> footPositionsOfSharedExtremity(const NodePath& path,
                                                              const BodyAxes& axes, double longest,
                                                              const TreeVolume& volume);

}  // namespace markerless_mocap
