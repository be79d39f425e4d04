#pragma once

#include <Eigen/Core>
#include <vector>

#include "hsiao/model/hsiao_body_model.h"

namespace markerless_mocap {

/// A round cone carried by a segment of H's profile.
struct HsiaoSegmentCone {
  int segment;
  Eigen::Vector3d a, b;       ///< ends in the segment's frame, metres
  double radius_a, radius_b;  ///< metres
};

/// A round cone in the world, ready for distances.
struct HsiaoWorldCone {
  Eigen::Vector3d a, ab;
  double inverse_length_squared;  ///< of ab; 0 for a sphere
  double radius_a, radius_growth;

  /// Metres, negative inside. The radius is taken where the point falls on the axis at a right
  /// angle, which is exact for equal radii.
  double signedDistance(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d ap = p - a;
    double t = ap.dot(ab) * inverse_length_squared;
    t = t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
    return (ap - t * ab).norm() - radius_a - t * radius_growth;
  }
};

/// A ball inside the body: a place on a cone's axis and the cone's radius there.
struct HsiaoInteriorSphere {
  HsiaoSegmentPoint center;
  double radius;  ///< metres
};

/// The body's shape seen by H's profile. Immutable.
class HsiaoBodyShape {
 public:
  HsiaoBodyShape(const BodyModel& model, const HsiaoBodyModel& profile);

  const std::vector<HsiaoSegmentCone>& cones() const { return cones_; }
  /// Balls that fill the cones, at most half a radius apart.
  const std::vector<HsiaoInteriorSphere>& balls() const { return balls_; }
  void inWorld(const HsiaoFrames& frames, std::vector<HsiaoWorldCone>& out) const;
  HsiaoWorldCone inWorld(const HsiaoFrames& frames, int cone) const;

 private:
  void fill(const HsiaoSegmentCone& cone);

  std::vector<HsiaoSegmentCone> cones_;
  std::vector<HsiaoInteriorSphere> balls_;
};

}  // namespace markerless_mocap
