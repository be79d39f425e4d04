#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// A point of a segment as linear function of the sizes: sum of size * along.
struct ShapeDependentPoint {
  struct Term {
    int size;
    Eigen::Vector3d along;
  };
  std::vector<Term> terms;

  Eigen::Vector3d at(const ShapeParameters& sizes) const {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (const Term& term : terms) p += sizes[term.size] * term.along;
    return p;
  }
};

/// A point that rides on a segment.
struct AttachedPoint {
  ContourSegment::Id segment;
  ShapeDependentPoint local;
};

/// How a segment hangs on its parent: by a ball, or by one to three axes in turn.
struct KinematicSegment {
  int parent = -1;
  int ball = -1;
  int first_angle = -1;
  std::vector<Eigen::Vector3d> axes;
  ShapeDependentPoint joint;  ///< in the parent's frame
  uint64_t dof_mask = 0;      ///< bit per degree of freedom
};

struct KinematicCone {
  ContourCone::Kind kind;
  ContourLimb::Id limb;
  AttachedPoint ends[2];
  int radius[2];  ///< indices into the sizes
};

/// The one topology of all cone bodies.
struct ContourKinematicTree {
  std::array<KinematicSegment, ContourSegment::kCount> segments;
  std::array<KinematicCone, kContourCones> cones;
  std::vector<AttachedPoint> points;  ///< of contourPointNames()
};
const ContourKinematicTree& contourKinematicTree();

/// d(world position)/d(pose), 3 rows; columns of degrees of freedom that do not move it are zero.
void poseJacobian(const ContourFrames& frames, int segment, const Eigen::Vector3d& at,
                  Eigen::Ref<Eigen::Matrix<double, 3, kContourDof>, 0, Eigen::OuterStride<>> J);
/// d(world position)/d(sizes).
void shapeJacobian(
    const ContourFrames& frames, const AttachedPoint& point,
    Eigen::Ref<Eigen::Matrix<double, 3, kShapeParameterCount>, 0, Eigen::OuterStride<>> J);

}  // namespace markerless_mocap
