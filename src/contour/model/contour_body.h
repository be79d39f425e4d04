#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "contour/model/contour_pose.h"
#include "markerless_mocap/tracking/shape_parameters.h"

namespace markerless_mocap {

/// Segments that move rigidly, parents before children.
struct ContourSegment {
  enum Id {
    kPelvis,
    kChest,
    kHead,
    kLeftClavicle,
    kRightClavicle,
    kLeftUpperArm,
    kRightUpperArm,
    kLeftForearm,
    kRightForearm,
    kLeftThigh,
    kRightThigh,
    kLeftShank,
    kRightShank,
    kLeftFoot,
    kRightFoot,
    kCount
  };
};

/// What evidence is told of.
struct ContourLimb {
  enum Id { kTrunk, kHead, kLeftArm, kRightArm, kLeftLeg, kRightLeg, kCount };
};

constexpr int kContourCones = 22;

/// Frames of all segments in the world, and the axis about which each degree of freedom turns.
struct ContourFrames {
  std::array<Eigen::Matrix3d, ContourSegment::kCount> R;
  std::array<Eigen::Vector3d, ContourSegment::kCount> t;  ///< metres
  Eigen::Matrix<double, 3, kContourDof> axis;   ///< world; the direction for the root's position
  Eigen::Matrix<double, 3, kContourDof> pivot;  ///< world, metres
};

/// A round cone in the world.
struct ContourWorldCone {
  Eigen::Vector3d a, b;       ///< ends, metres
  double radius_a, radius_b;  ///< metres
};
using ContourWorldCones = std::array<ContourWorldCone, kContourCones>;

/// The body of 22 round cones on 15 segments that silhouettes are fitted with. Its joints are those
/// of the URDF body, with a twist of the spine more. Immutable.
class ContourBody {
 public:
  /// Throws std::invalid_argument unless all sizes are finite and lengths and radii positive.
  explicit ContourBody(const ShapeParameters& sizes);
  const ShapeParameters& sizes() const { return sizes_; }

  void place(const ContourPose& pose, ContourFrames& frames) const;
  void place(const ContourFrames& frames, ContourWorldCones& cones) const;

  /// World positions of contourPointNames(), metres, as columns.
  Eigen::Matrix3Xd points(const ContourPose& pose) const;

 private:
  ShapeParameters sizes_;
  std::array<Eigen::Vector3d, ContourSegment::kCount> joints_;      ///< in the parent's frame
  std::array<std::array<Eigen::Vector3d, 2>, kContourCones> ends_;  ///< in the segment's frame
};

/// The limb a cone belongs to, and its kind.
ContourLimb::Id limbOfCone(int cone);
ContourCone::Kind kindOfCone(int cone);

/// The fifteen of markerNames(), then l_hand_tip, r_hand_tip, l_foot_tip, r_foot_tip, head_top.
const std::vector<std::string>& contourPointNames();

}  // namespace markerless_mocap
