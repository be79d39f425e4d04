#include "hsiao/fit/hull_agreement.h"

#include <algorithm>
#include <array>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

bool isExplained(const std::vector<HsiaoWorldCone>& cones, const Vector3d& point, double margin) {
  return std::any_of(cones.begin(), cones.end(), [&](const HsiaoWorldCone& cone) {
    return cone.signedDistance(point) <= margin;
  });
}

double explainedShare(const std::vector<HsiaoWorldCone>& cones, const VisualHull& hull,
                      double margin) {
  size_t explained = 0;
  for (const HullVoxel& voxel : hull.voxels)
    explained += isExplained(cones, hull.lattice.center(voxel.index), margin);
  return hull.voxels.empty() ? 0.0 : double(explained) / hull.voxels.size();
}

// Each sphere is tested at its centre and at the corners of its inscribed cube, weighted by its
// volume.
double insideFraction(const HsiaoBodyShape& shape, const HsiaoFrames& frames,
                      const HullDistanceField& field) {
  static const std::array<Vector3d, 9> kProbes = {
      Vector3d(0, 0, 0),   Vector3d(1, 1, 1),   Vector3d(1, 1, -1),
      Vector3d(1, -1, 1),  Vector3d(1, -1, -1), Vector3d(-1, 1, 1),
      Vector3d(-1, 1, -1), Vector3d(-1, -1, 1), Vector3d(-1, -1, -1)};
  const double corner = 0.5;  // 0.87 of the radius from the centre
  double inside = 0.0, all = 0.0;
  for (const HsiaoInteriorSphere& sphere : shape.spheres()) {
    const Vector3d center = sphere.center.inWorld(frames);
    const double weight = sphere.radius * sphere.radius * sphere.radius;
    for (const Vector3d& probe : kProbes) {
      all += weight;
      if (field.signedDistance(center + corner * sphere.radius * probe) < 0.0) inside += weight;
    }
  }
  return all > 0.0 ? inside / all : 0.0;
}

}  // namespace

HullAgreement measureHullAgreement(const HsiaoBodyShape& shape, const HsiaoFrames& frames,
                                   const VisualHull& hull, const HullDistanceField& field,
                                   double margin) {
  std::vector<HsiaoWorldCone> cones;
  shape.inWorld(frames, cones);
  return {explainedShare(cones, hull, margin), insideFraction(shape, frames, field)};
}

}  // namespace markerless_mocap
