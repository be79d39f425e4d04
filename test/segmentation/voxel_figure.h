#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// A hull painted from capsules, each belonging to a part; the first to take a voxel keeps it.
class VoxelFigure {
 public:
  explicit VoxelFigure(double pitch = 0.03) {
    lattice_.origin = {-1.2, -0.6, 0.0};
    lattice_.pitch = pitch;
    lattice_.size = (Eigen::Vector3d(2.4, 1.2, 1.95) / pitch).cast<int>();
  }

  VoxelFigure& capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
                       PartLabel part = PartLabel::kTorso) {
    const Eigen::Vector3d axis = b - a;
    for (uint32_t index = 0; index < lattice_.count(); ++index) {
      const Eigen::Vector3d p = lattice_.center(index);
      const double length = std::max(axis.squaredNorm(), 1e-12);
      const double t = std::clamp((p - a).dot(axis) / length, 0.0, 1.0);
      if ((p - a - t * axis).norm() <= radius) part_.emplace(index, part);
    }
    return *this;
  }

  /// Voxels by ascending index.
  VisualHull hull() const {
    VisualHull hull;
    hull.lattice = lattice_;
    hull.status = HullStatus::kOk;
    for (const auto& [index, part] : part_) {
      HullVoxel voxel;
      voxel.index = index;
      hull.voxels.push_back(voxel);
    }
    return hull;
  }

  /// True part of each voxel of hull().
  std::vector<PartLabel> parts() const {
    std::vector<PartLabel> parts;
    for (const auto& [index, part] : part_) parts.push_back(part);
    return parts;
  }

 private:
  VoxelLattice lattice_;
  std::map<uint32_t, PartLabel> part_;
};

/// A person of 1.73 m without arms, the right limbs (x > 0) are arm 1 and leg 1.
inline void paintTrunkAndLegs(VoxelFigure* figure) {
  for (const int side : {1, -1}) {
    const PartLabel leg = side > 0 ? PartLabel::kLeg1 : PartLabel::kLeg2;
    const Eigen::Vector3d knee(side * 0.16, 0.0, 0.46);
    figure->capsule({side * 0.12, 0.0, 0.80}, knee, 0.08, leg);
    figure->capsule(knee, {side * 0.18, 0.0, 0.08}, 0.055, leg);
    figure->capsule({side * 0.18, -0.02, 0.04}, {side * 0.18, 0.14, 0.04}, 0.04, leg);
  }
  figure->capsule({0, 0, 1.52}, {0, 0, 1.46}, 0.06, PartLabel::kHead);
  figure->capsule({0, 0, 1.65}, {0, 0, 1.61}, 0.09, PartLabel::kHead);
  figure->capsule({-0.21, 0, 1.38}, {0.21, 0, 1.38}, 0.06);
  figure->capsule({-0.04, 0, 0.90}, {-0.04, 0, 1.28}, 0.125);
  figure->capsule({0.04, 0, 0.90}, {0.04, 0, 1.28}, 0.125);
}

/// The same who faces +y, arms straight, `arm_angle` radians from hanging.
inline VoxelFigure standingFigure(double arm_angle, double pitch = 0.03) {
  VoxelFigure figure(pitch);
  for (const int side : {1, -1}) {
    const PartLabel arm = side > 0 ? PartLabel::kArm1 : PartLabel::kArm2;
    const Eigen::Vector3d shoulder(side * 0.21, 0.0, 1.38);
    const Eigen::Vector3d along(side * std::sin(arm_angle), 0.0, -std::cos(arm_angle));
    figure.capsule(shoulder + 0.08 * along, shoulder + 0.28 * along, 0.050, arm);
    figure.capsule(shoulder + 0.28 * along, shoulder + 0.52 * along, 0.042, arm);
    figure.capsule(shoulder + 0.52 * along, shoulder + 0.70 * along, 0.034, arm);
  }
  paintTrunkAndLegs(&figure);
  return figure;
}

/// The same with bent arms: upper arms from the shoulder to an elbow, from there to a wrist and a
/// hand, given for the right arm and mirrored for the left.
inline VoxelFigure bentArmsFigure(const Eigen::Vector3d& elbow, const Eigen::Vector3d& wrist,
                                  const Eigen::Vector3d& hand, bool both = true) {
  VoxelFigure figure;
  for (const int side : {1, -1}) {
    const PartLabel arm = side > 0 ? PartLabel::kArm1 : PartLabel::kArm2;
    const Eigen::Vector3d mirror(side, 1, 1);
    const bool bent = both || side > 0;
    const Eigen::Vector3d straight(-0.75, 0.0, 1.15);
    const Eigen::Vector3d shoulder(side * 0.21, 0.0, 1.38);
    const Eigen::Vector3d along = (straight - shoulder).normalized();
    const Eigen::Vector3d a = bent ? elbow.cwiseProduct(mirror).eval() : shoulder + 0.28 * along;
    const Eigen::Vector3d b = bent ? wrist.cwiseProduct(mirror).eval() : shoulder + 0.52 * along;
    const Eigen::Vector3d c = bent ? hand.cwiseProduct(mirror).eval() : shoulder + 0.70 * along;
    figure.capsule(shoulder + 0.08 * (a - shoulder).normalized(), a, 0.050, arm);
    figure.capsule(a, b, 0.042, arm).capsule(b, c, 0.034, arm);
  }
  paintTrunkAndLegs(&figure);
  return figure;
}

}  // namespace markerless_mocap
