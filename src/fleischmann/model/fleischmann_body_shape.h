#pragma once

#include <array>
#include <vector>

#include "fleischmann/fleischmann_body_model.h"
#include "markerless_mocap/fleischmann/fleischmann_options.h"

namespace markerless_mocap {

/// The ten truncated cones, in the order of Fleischmann 2012, Table 5.2.
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

/// A set of cones as bits.
using ConeSet = unsigned;
constexpr ConeSet coneBit(FleischmannConeId cone) {
  return 1u << cone;
}
constexpr ConeSet kTorsoOnly = coneBit(kTorsoCone);
/// All cones but the head, whose shape is too coarse for edges.
constexpr ConeSet kAllButHead = (1u << kHeadCone) - 1;

/// A truncated elliptic cone, fixed to a segment; all cross-sections have the same shape.
struct FleischmannCone {
  FleischmannSegment segment = kPelvisSegment;
  Eigen::Vector3d a, b;  ///< centres of the ends in the segment's frame, metres
  /// Half axes of the end at `a`, perpendicular to b - a and to each other, metres.
  Eigen::Vector3d u, v;
  double taper = 1.0;  ///< scale of the end at `b` relative to that at `a`
};

/// Scale of a person's cones relative to those of the body model.
struct FleischmannConeScale {
  double width = 1.0;    ///< factor of the half axis in lateral direction
  double depth = 1.0;    ///< factor of the half axis in depth
  double taper = 1.0;    ///< factor of the taper
  double forward = 0.0;  ///< shift to the front of the segment, metres
};

/// The body as ten truncated cones. Immutable.
class FleischmannBodyShape {
 public:
  /// Derives the cones from the geometry of the model: the torso from below the hips to the
  /// shoulders, the limbs from joint to joint, the head around its upper part. Calves and lower
  /// arms cover heels and wrists (Fleischmann 2012, 5.1.2). Throws std::invalid_argument if a link
  /// has no geometry.
  FleischmannBodyShape(const BodyModel& model, const FleischmannBodyModel& body_model,
                       const FleischmannBodyOptions& options = {});

  const std::array<FleischmannCone, kFleischmannConeCount>& cones() const { return cones_; }
  /// The same body with scaled cones. \param scales indexed by FleischmannConeId; factors greater
  /// than 0
  FleischmannBodyShape scaled(
      const std::array<FleischmannConeScale, kFleischmannConeCount>& scales) const;

 private:
  std::array<FleischmannCone, kFleischmannConeCount> cones_;
};

/// Test for limbs that penetrate each other or the torso (Fleischmann 2012, 5.3.2). Two limbs
/// collide if the distance of their axes is less than `fraction` times the sum of their radii. A
/// lower arm collides with the torso if it is inside the cross-section scaled accordingly. Limbs
/// that share a joint are not compared; thighs, which meet at the pelvis, from a third of their
/// length on.
class LimbCollision {
 public:
  /// Uses collision_fraction, 0 (never) to 1 (surfaces may not touch), and collision_pairs.
  LimbCollision(const FleischmannBodyShape& body, const FleischmannBodyOptions& options);
  bool operator()(const FleischmannFrames& frames) const;

 private:
  struct Limb {
    FleischmannSegment segment;
    Eigen::Vector3d a, b;
    double radius;
  };
  bool inTorso(const Eigen::Vector3d& point, const FleischmannFrames& frames, double radius) const;

  struct Pair {
    FleischmannConeId a, b;
    double from;  ///< fraction of both axes that is left out at the upper end
  };
  static std::vector<Pair> pairsOf(bool all);

  std::array<Limb, kFleischmannConeCount> limbs_;
  FleischmannCone torso_;
  double fraction_;
  std::vector<Pair> pairs_;
};

}  // namespace markerless_mocap
