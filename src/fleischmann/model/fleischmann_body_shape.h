#pragma once

#include <array>

#include "fleischmann/fleischmann_body_model.h"

namespace markerless_mocap {

/// The ten truncated cones in F's order (Fleischmann 2012, Table 5.2).
enum FleischmannConeId {
  kTorsoCone = 0,
  kLeftThighCone,
  kLeftCalfCone,
  kRightThighCone,
  kRightCalfCone,
  kLeftUpperArmCone,
  kLeftLowerArmCone,
  kRightUpperArmCone,
  kRightLowerArmCone,
  kHeadCone,
  kFleischmannConeCount
};

/// A set of cones as bits, for what an edge fitness looks at.
using ConeSet = unsigned;
constexpr ConeSet coneBit(FleischmannConeId cone) {
  return 1u << cone;
}
constexpr ConeSet kTorsoOnly = coneBit(kTorsoCone);
/// All but the head, whose cone is too crude for edges.
constexpr ConeSet kAllButHead = (1u << kHeadCone) - 1;

/// A truncated elliptic cone, rigid with a segment: its cross-sections are ellipses of one shape.
struct FleischmannCone {
  FleischmannSegment segment = kPelvisSegment;
  Eigen::Vector3d a, b;  ///< centres of the ends in the segment's frame, metres
  /// Half axes of the end at `a`, perpendicular to b - a and to each other, metres.
  Eigen::Vector3d u, v;
  double taper = 1.0;  ///< size of the end at `b` against that at `a`
};

/// How a person's cones differ from those that are measured on the body model.
struct FleischmannConeScale {
  double width = 1.0;    ///< factor of the half axis from side to side
  double depth = 1.0;    ///< factor of the half axis from back to front
  double taper = 1.0;    ///< factor of the taper
  double forward = 0.0;  ///< shift to the front of the segment, metres
};

/// The body as ten truncated cones. Immutable.
class FleischmannBodyShape {
 public:
  /// Measures the cones on the model's shape: the torso from under the hips to the shoulders, the
  /// limbs from joint to joint, calves and lower arms longer by a fifth so that they cover heels
  /// and wrists, the head over its upper part (F 5.1.2). Throws std::invalid_argument if a link
  /// has no shape.
  FleischmannBodyShape(const BodyModel& model, const FleischmannBodyModel& profile);

  const std::array<FleischmannCone, kFleischmannConeCount>& cones() const { return cones_; }
  /// The same body with other sizes. \param sizes by FleischmannConeId, factors above 0
  FleischmannBodyShape resized(
      const std::array<FleischmannConeScale, kFleischmannConeCount>& sizes) const;

 private:
  std::array<FleischmannCone, kFleischmannConeCount> cones_;
};

/// Whether limbs run through each other or arms through the torso (Fleischmann 2012, 5.3.2): axes
/// of limbs nearer than `share` of the sum of their radii, or lower arms deeper in the torso than
/// that share of its section and their radius leave. Limbs that share a joint are not compared.
class LimbCollision {
 public:
  /// \param share 0 (never) to 1 (surfaces may not touch)
  LimbCollision(const FleischmannBodyShape& body, double share);
  bool operator()(const FleischmannFrames& frames) const;

 private:
  struct Limb {
    FleischmannSegment segment;
    Eigen::Vector3d a, b;
    double radius;
  };
  bool inTorso(const Eigen::Vector3d& point, const FleischmannFrames& frames, double radius) const;

  std::array<Limb, kFleischmannConeCount> limbs_;
  FleischmannCone torso_;
  double share_;
};

}  // namespace markerless_mocap
