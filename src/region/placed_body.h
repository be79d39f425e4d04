#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "region/region_segmenter.h"

namespace markerless_mocap {

/// A round cone of the body in the world: the convex hull of two spheres.
struct PlacedCone {
  Eigen::Vector3d a, b;       ///< ends, metres
  double radius_a, radius_b;  ///< metres
  int part;                   ///< part of the body, from 0
};

/// A body in its pose.
struct PlacedBody {
  std::vector<PlacedCone> cones;
  Eigen::Vector3d pelvis;  ///< metres
  int parts;               ///< their number
};

/// Samples of the image that are one metre long at a point.
/// \param step pixels from one sample to the next
float samplesPerMetre(const Camera& camera, int step, const Eigen::Vector3d& point);

/// The body as the camera sees it; cones that lie behind the camera are left out.
/// \param step pixels from one sample to the next
/// \param error_m expected error of the outline
ProjectedBody projectedBody(const Camera& camera, int step, const PlacedBody& body, double error_m);

}  // namespace markerless_mocap
