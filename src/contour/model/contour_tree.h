#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// A point of a segment as linear function of the sizes: sum of size * along.
struct SizedPoint {
  struct Term {
    int size;
    Eigen::Vector3d along;
  };
  std::vector<Term> terms;

  Eigen::Vector3d at(const ContourSizes& sizes) const {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (const Term& term : terms) p += sizes[term.size] * term.along;
    return p;
  }
};

/// A point that rides on a segment.
struct RiddenPoint {
  ContourSegment::Id segment;
  SizedPoint local;
};

/// How a segment hangs on its parent: by a ball, or by one to three axes in turn.
struct TreeSegment {
  int parent = -1;
  int ball = -1;
  int first_angle = -1;
  std::vector<Eigen::Vector3d> axes;
  SizedPoint joint;       ///< in the parent's frame
  uint64_t moved_by = 0;  ///< bit per degree of freedom
};

struct TreeCone {
  ContourCone::Kind kind;
  ContourLimb::Id limb;
  RiddenPoint ends[2];
  int radius[2];  ///< indices into the sizes
};

/// The one topology of all cone bodies.
struct ContourTree {
  std::array<TreeSegment, ContourSegment::kCount> segments;
  std::array<TreeCone, kContourCones> cones;
  std::vector<RiddenPoint> points;  ///< of contourPointNames()
};
const ContourTree& contourTree();

/// d(world position)/d(pose), 3 rows; columns of degrees of freedom that do not move it are zero.
void poseJacobian(const ContourFrames& frames, int segment, const Eigen::Vector3d& at,
                  Eigen::Ref<Eigen::Matrix<double, 3, kContourDof>, 0, Eigen::OuterStride<>> J);
/// d(world position)/d(sizes).
void sizeJacobian(const ContourFrames& frames, const RiddenPoint& point,
                  Eigen::Ref<Eigen::Matrix<double, 3, kContourSizes>, 0, Eigen::OuterStride<>> J);

}  // namespace markerless_mocap
