#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// A point in a segment's frame as a linear function of the shape: sum of parameter * along.
struct ShapeDependentPoint {
  struct Term {
    int size;
    Eigen::Vector3d along;
  };
  std::vector<Term> terms;

  Eigen::Vector3d at(const ShapeParameters& shape) const {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (const Term& term : terms) p += shape[term.size] * term.along;
    return p;
  }
};

/// A point fixed to a segment.
struct AttachedPoint {
  ContourSegment::Id segment;
  ShapeDependentPoint local;
};

/// Joint between a segment and its parent: a spherical joint, or one to three revolute joints.
struct KinematicSegment {
  int parent = -1;
  int spherical_joint = -1;
  int first_angle = -1;
  std::vector<Eigen::Vector3d> axes;
  ShapeDependentPoint joint;  ///< in the parent's frame
  uint64_t dof_mask = 0;      ///< one bit per degree of freedom
};

struct KinematicCone {
  BodyCone::Kind kind;
  ContourLimb::Id limb;
  AttachedPoint ends[2];
  int radius[2];  ///< indices of the shape parameters
};

/// The kinematic tree, which all contour bodies share.
struct ContourKinematicTree {
  std::array<KinematicSegment, ContourSegment::kCount> segments;
  std::array<KinematicCone, kContourCones> cones;
  std::vector<AttachedPoint> points;  ///< of contourPointNames()
};
const ContourKinematicTree& contourKinematicTree();

/// d(world position)/d(pose), 3 rows; columns of degrees of freedom that do not move the point are
/// 0.
void poseJacobian(const ContourFrames& frames, int segment, const Eigen::Vector3d& at,
                  Eigen::Ref<Eigen::Matrix<double, 3, kContourDof>, 0, Eigen::OuterStride<>> J);
/// d(world position)/d(shape parameters).
void shapeJacobian(
    const ContourFrames& frames, const AttachedPoint& point,
    Eigen::Ref<Eigen::Matrix<double, 3, kShapeParameterCount>, 0, Eigen::OuterStride<>> J);

}  // namespace markerless_mocap
