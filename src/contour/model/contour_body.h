#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "contour/model/contour_pose.h"
#include "markerless_mocap/tracking/shape_parameters.h"

namespace markerless_mocap {

/// Rigid segments, parents before children.
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

/// The parts of the body that evidence is given for.
struct ContourLimb {
  enum Id { kTrunk, kHead, kLeftArm, kRightArm, kLeftLeg, kRightLeg, kCount };
};

constexpr int kContourCones = 22;

/// Frames of all segments in the world, and the axis of each degree of freedom.
struct ContourFrames {
  std::array<Eigen::Matrix3d, ContourSegment::kCount> R;
  std::array<Eigen::Vector3d, ContourSegment::kCount> t;  ///< metres
  Eigen::Matrix<double, 3, kContourDof> axis;   ///< world; for the root's position: its direction
  Eigen::Matrix<double, 3, kContourDof> pivot;  ///< world, metres
};

/// A round cone in the world: the convex hull of two spheres.
struct ContourWorldCone {
  Eigen::Vector3d a, b;       ///< ends, metres
  double radius_a, radius_b;  ///< metres
};
using ContourWorldCones = std::array<ContourWorldCone, kContourCones>;

/// The body that is fitted to silhouettes: 22 round cones on 15 segments. Its joints are those of
/// the URDF body plus a twist of the spine. Immutable.
class ContourBody {
 public:
  /// Throws std::invalid_argument if a parameter is not finite, or if a length or radius is not
  /// positive.
  explicit ContourBody(const ShapeParameters& shape);
  const ShapeParameters& shape() const { return shape_; }

  void place(const ContourPose& pose, ContourFrames& frames) const;
  void place(const ContourFrames& frames, ContourWorldCones& cones) const;

  /// World positions of contourPointNames(), metres, as columns.
  Eigen::Matrix3Xd points(const ContourPose& pose) const;

 private:
  ShapeParameters shape_;
  std::array<Eigen::Vector3d, ContourSegment::kCount> joints_;      ///< of each segment, in the
                                                                    ///< parent's frame
  std::array<std::array<Eigen::Vector3d, 2>, kContourCones> ends_;  ///< of each cone, in the
                                                                    ///< segment's frame
};

ContourLimb::Id limbOfCone(int cone);

/// The 15 names of markerNames(), then l_hand_tip, r_hand_tip, l_foot_tip, r_foot_tip, head_top.
const std::vector<std::string>& contourPointNames();
/// A limb's end among them: of the trunk the base of the neck, the head, a wrist or an ankle.
size_t endOfLimb(ContourLimb::Id limb);

}  // namespace markerless_mocap
