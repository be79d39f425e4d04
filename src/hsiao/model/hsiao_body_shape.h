#pragma once

#include <Eigen/Core>
#include <vector>

#include "hsiao/model/hsiao_body_model.h"

namespace markerless_mocap {

/// A round cone fixed to a segment.
struct HsiaoSegmentCone {
  int segment;
  Eigen::Vector3d a, b;       ///< ends in the segment's frame, metres
  double radius_a, radius_b;  ///< metres
};

/// A round cone in the world, with precomputed values for distances.
struct HsiaoWorldCone {
  Eigen::Vector3d a, ab;
  double inverse_length_squared;  ///< of ab; 0 for a sphere
  double radius_a, radius_growth;

  /// Metres, negative inside. The radius is taken at the foot of the perpendicular on the axis,
  /// which is exact for equal radii.
  double signedDistance(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d ap = p - a;
    double t = ap.dot(ab) * inverse_length_squared;
    t = t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
    return (ap - t * ab).norm() - radius_a - t * radius_growth;
  }
};

/// A sphere inside the body, on the axis of a cone and with its radius.
struct HsiaoInteriorSphere {
  HsiaoSegmentPoint center;
  double radius;  ///< metres
};

/// The geometry of the body, attached to the segments of Hsiao's model. Immutable.
class HsiaoBodyShape {
 public:
  HsiaoBodyShape(const BodyModel& model, const HsiaoBodyModel& body_model);

  const std::vector<HsiaoSegmentCone>& cones() const { return cones_; }
  /// Spheres that fill the cones, at most half a radius apart.
  const std::vector<HsiaoInteriorSphere>& spheres() const { return spheres_; }
  void inWorld(const HsiaoFrames& frames, std::vector<HsiaoWorldCone>& out) const;
  HsiaoWorldCone inWorld(const HsiaoFrames& frames, int cone) const;

 private:
  void fill(const HsiaoSegmentCone& cone);

  std::vector<HsiaoSegmentCone> cones_;
  std::vector<HsiaoInteriorSphere> spheres_;
};

}  // namespace markerless_mocap
