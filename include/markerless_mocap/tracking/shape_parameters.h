#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {

/// Distances between joints, as in BodyProportions.
struct BodyLength {
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

/// Round cones of the body: two spheres of different radius and their convex hull. All but neck and
/// head exist on both sides, mirrored.
struct BodyCone {
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

/// Each end of a cone has a radius and an offset. The offset is the vector from the joint, or from
/// the point that the lengths alone determine, to the centre of the end. It is given in the frame
/// of the segment, for the left side.
constexpr int kValuesPerEnd = 4;
constexpr int radiusIndex(int kind, int end) {
  return BodyLength::kCount + (2 * kind + end) * kValuesPerEnd;
}
constexpr int offsetIndex(int kind, int end) {
  return radiusIndex(kind, end) + 1;  // x, y, z
}
constexpr int kShapeParameterCount = BodyLength::kCount + 2 * BodyCone::kCount * kValuesPerEnd;

/// Shape parameters of a body, metres: the lengths, then radius and offset x y z of each end of
/// each kind of cone.
using ShapeParameters = Eigen::Matrix<double, kShapeParameterCount, 1>;

/// "torso", "thigh_cone/a/radius", "thigh_cone/b/offset_x", ...
const std::string& shapeParameterName(int parameter);
bool isOffset(int parameter);

/// The lengths for the URDF; girth is the mean ratio of the radii of chest, thigh, calf and upper
/// arm to those of the URDF.
BodyProportions proportionsOf(const ShapeParameters& shape);

/// Mean and standard deviation of each shape parameter over people, as fractions of the stature. A
/// parameter of deviation 0 is not estimated.
struct ShapeStatistics {
  ShapeParameters mean = ShapeParameters::Zero();
  ShapeParameters deviation = ShapeParameters::Zero();

  /// The lengths of BodyProportions::fromStature() and the radii in urdf/human.urdf.in. Offsets
  /// have deviation 0. Used if no statistics were learned.
  static ShapeStatistics handMade();
  /// Mean over people of known shape. The sample is usually too small for its deviations to hold
  /// for all people. The deviations are therefore set to 5 % for lengths, 25 % for radii, which
  /// clothes change, and for offsets to twice the deviation of the sample and 0.002 of the stature
  /// (root sum of squares). An offset that is 0 for all people stays fixed.
  /// \param shapes of each person, metres
  /// \param statures of each person, metres. Throws std::invalid_argument if there is no person, if
  ///   the two numbers differ, or if a stature is not in 0.5 to 2.5 m
  static ShapeStatistics fromPeople(const std::vector<ShapeParameters>& shapes,
                                    const std::vector<double>& statures);
  /// The mean shape at a stature, metres.
  /// \param stature metres, 0.5 to 2.5, else std::invalid_argument
  ShapeParameters meanShape(double stature) const;
  /// Throws std::invalid_argument if the text is no YAML map, if a parameter is missing, given
  /// twice, unknown or no pair of finite numbers, if the mean of a length or radius is not
  /// positive, or if a deviation is negative. The message names `where` and the parameter.
  static ShapeStatistics fromYaml(const std::string& yaml, const std::string& where);
  /// The text for fromYaml(), with comments that describe it.
  std::string text() const;
};

}  // namespace markerless_mocap
