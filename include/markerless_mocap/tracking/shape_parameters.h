#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {

/// Distances between joints, as in BodyProportions.
struct ContourLength {
  enum Id {
    kTorso,
    kNeck,
    kHead,
    kUpperArm,
    kForearm,
    kHand,
    kThigh,
    kShank,
    kFoot,
    kAnkleHeight,
    kShoulderWidth,
    kHipWidth,
    kCount
  };
};

/// Round cones of the body. All but neck and head exist on both sides, mirrored.
struct ContourCone {
  enum Kind {
    kPelvis,
    kChest,
    kYoke,
    kNeck,
    kHead,
    kUpperArm,
    kForearm,
    kHand,
    kThigh,
    kCalf,
    kShin,
    kFoot,
    kCount
  };
};

/// One end of a cone has a radius and an offset from where the lengths alone would put it: where
/// the joint sits in the flesh. The offset is in the frame of the segment, of the left side.
constexpr int kValuesPerEnd = 4;
constexpr int radiusIndex(int kind, int end) {
  return ContourLength::kCount + (2 * kind + end) * kValuesPerEnd;
}
constexpr int offsetIndex(int kind, int end) {
  return radiusIndex(kind, end) + 1;  // x, y, z
}
constexpr int kShapeParameterCount =
    ContourLength::kCount + 2 * ContourCone::kCount * kValuesPerEnd;

/// All sizes of a body, metres: the lengths, then radius and offset x y z of each end of each kind
/// of cone.
using ShapeParameters = Eigen::Matrix<double, kShapeParameterCount, 1>;

/// "torso", "thigh_cone/a/radius", "thigh_cone/b/offset_x", ...
const std::string& shapeParameterName(int size);
bool isOffset(int size);

/// The lengths as the URDF takes them; girth from the estimated radii of chest, thigh and arm.
BodyProportions proportionsOf(const ShapeParameters& sizes);

/// What bodies look like: every size as a share of the stature, its mean and standard deviation
/// over people. A size of deviation zero is never estimated.
struct ShapeStatistics {
  ShapeParameters mean = ShapeParameters::Zero();
  ShapeParameters deviation = ShapeParameters::Zero();

  /// Lengths of BodyProportions::fromStature() and the radii that urdf/human.urdf.in draws; only
  /// lengths and radii vary. To begin with where no template was learned.
  static ShapeStatistics handMade();
  /// Mean over people whose sizes are known. As people who serve as examples rarely scatter as all
  /// people do, lengths are let vary by 5 % and radii, which clothes change, by 25 %; offsets by
  /// twice their own scatter and 2 mm per metre of stature. An offset that is 0 in all stays so.
  /// \param statures metres, of each. Throws std::invalid_argument unless there are as many of
  /// both, at least one, and they are in 0.5 to 2.5 m.
  static ShapeStatistics fromPeople(const std::vector<ShapeParameters>& sizes,
                                    const std::vector<double>& statures);
  /// \param stature metres, 0.5 to 2.5, else std::invalid_argument
  ShapeParameters sizes(double stature) const;
  /// Throws std::invalid_argument in one sentence that names `where` and the size: no YAML map, a
  /// size missing, doubled or unknown, not a pair of finite numbers, a length or radius that is not
  /// positive, a negative deviation.
  static ShapeStatistics fromYaml(const std::string& yaml, const std::string& where);
  /// What fromYaml() reads, with its meaning in comments.
  std::string text() const;
};

}  // namespace markerless_mocap
