#pragma once

#include <Eigen/Core>

#include "skeleton/graph/tree_volume.h"
#include "skeleton/labelling/label_choice.h"
#include "skeleton/labelling/left_right.h"

namespace markerless_mocap {

/// Knuckles, ball of the foot or middle of the head from the path of a limb: the path is led on to
/// the surface, and the point lies a share of the body's size before that. The shares were fitted
/// on people of the virtual studio.
/// \param path from the end upwards, at least one point
/// \param closed the end touches the body: the path is as long as the limb and not led on
/// \param longest the measure of the proportions, metres
Eigen::Vector3d extremityPosition(const NodePath& path, UnsidedExtremity end, bool closed,
                                  double longest, const TreeVolume& volume);

/// The balls of two feet that share one end: what is left and right of the end's middle.
std::array<Eigen::Vector3d, 2> footPositionsOfSharedExtremity(const NodePath& path,
                                                              const BodyAxes& axes, double longest,
                                                              const TreeVolume& volume);

}  // namespace markerless_mocap
