#pragma once

#include <Eigen/Core>
#include <optional>

#include "markerless_mocap/capture/renderer.h"

namespace markerless_mocap {

struct RayHit {
  double distance;         ///< metres along the ray
  Eigen::Vector3d normal;  ///< unit, outward
};

/// Where rays from one point first enter a round cone: the convex hull of the spheres at its ends.
class RoundConeCaster {
 public:
  /// \param eye outside the cone
  RoundConeCaster(const SolidCone& cone, const Eigen::Vector3d& eye);
  /// \param direction unit
  std::optional<RayHit> cast(const Eigen::Vector3d& direction) const;

 private:
  void hitSphere(const Eigen::Vector3d& eye, double radius, const Eigen::Vector3d& direction,
                 std::optional<RayHit>& best) const;
  void hitSide(const Eigen::Vector3d& direction, std::optional<RayHit>& best) const;

  double radius_a_, radius_b_;
  Eigen::Vector3d axis_;           ///< from a to b
  Eigen::Vector3d eye_a_, eye_b_;  ///< eye seen from a and from b
  bool has_side_;                  ///< neither sphere holds the other
  double slant_squared_;           ///< squared length of the side's generator
  double axis_eye_;
};

}  // namespace markerless_mocap
