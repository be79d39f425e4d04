#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <set>

#include "markerless_mocap/products/curve_skeleton.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Voxels painted in a lattice of 2.4 x 2.4 x 2 m about the z axis.
class TreeFigure {
 public:
  explicit TreeFigure(double pitch) {
    lattice_.origin = {-1.2, -1.2, 0.0};
    lattice_.pitch = pitch;
    lattice_.size = (Eigen::Vector3d(2.4, 2.4, 2.0) / pitch).cast<int>();
  }

  TreeFigure& capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius) {
    const Eigen::Vector3i low = cell(a.cwiseMin(b) - Eigen::Vector3d::Constant(radius));
    const Eigen::Vector3i high = cell(a.cwiseMax(b) + Eigen::Vector3d::Constant(radius));
    const Eigen::Vector3d axis = b - a;
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i) {
          const uint32_t index = lattice_.index(i, j, k);
          const Eigen::Vector3d p = lattice_.center(index);
          const double t =
              std::clamp((p - a).dot(axis) / std::max(axis.squaredNorm(), 1e-12), 0.0, 1.0);
          if ((p - a - t * axis).norm() <= radius) voxels_.insert(index);
        }
    return *this;
  }

  /// One voxel wide.
  TreeFigure& line(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3i from = cell(a), path_length = cell(b) - from;
    const int steps = std::max(1, path_length.cwiseAbs().maxCoeff());
    for (int s = 0; s <= steps; ++s) {
      const Eigen::Vector3d fraction = path_length.cast<double>() * s / steps;
      const Eigen::Vector3i at = from + fraction.array().round().matrix().cast<int>();
      voxels_.insert(lattice_.index(at.x(), at.y(), at.z()));
    }
    return *this;
  }

  VisualHull hull() const {
    VisualHull hull;
    hull.lattice = lattice_;
    hull.status = HullStatus::kOk;
    for (const uint32_t index : voxels_) {
      hull.voxels.emplace_back();
      hull.voxels.back().index = index;
    }
    return hull;
  }
  CurveSkeleton skeleton() const { return {lattice_, {voxels_.begin(), voxels_.end()}}; }

 private:
  Eigen::Vector3i cell(const Eigen::Vector3d& p) const {
    return ((p - lattice_.origin) / lattice_.pitch).array().floor().matrix().cast<int>();
  }

  VoxelLattice lattice_;
  std::set<uint32_t> voxels_;
};

/// Ends of a person of 1.73 m at the z axis who faces +x: left is +y.
struct FigurePose {
  Eigen::Vector3d left_elbow{0.0, 0.42, 1.30}, left_hand{0.12, 0.66, 1.25};
  Eigen::Vector3d right_elbow{0.0, -0.42, 1.30}, right_hand{0.12, -0.66, 1.25};
  Eigen::Vector3d left_knee{0.06, 0.15, 0.47}, left_ankle{-0.02, 0.18, 0.09};
  Eigen::Vector3d right_knee{0.06, -0.15, 0.47}, right_ankle{-0.02, -0.18, 0.09};
};

/// The same person in a mirror that stands along x.
inline FigurePose mirrored(const FigurePose& pose) {
  const auto flip = [](Eigen::Vector3d p) {
    p.y() = -p.y();
    return p;
  };
  return {flip(pose.right_elbow), flip(pose.right_hand), flip(pose.left_elbow),
          flip(pose.left_hand),   flip(pose.right_knee), flip(pose.right_ankle),
          flip(pose.left_knee),   flip(pose.left_ankle)};
}

inline void addPerson(const FigurePose& pose, const Eigen::Vector3d& at, TreeFigure* figure) {
  const auto limb = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius) {
    figure->capsule(a + at, b + at, radius);
  };
  limb({0, -0.05, 0.95}, {0, -0.05, 1.32}, 0.12);
  limb({0, 0.05, 0.95}, {0, 0.05, 1.32}, 0.12);
  limb({0, -0.17, 1.40}, {0, 0.17, 1.40}, 0.06);
  limb({0, 0, 1.40}, {0.01, 0, 1.55}, 0.06);
  limb({0.02, 0, 1.60}, {0.02, 0, 1.64}, 0.09);
  const auto side = [&](double y, const Eigen::Vector3d& elbow, const Eigen::Vector3d& hand,
                        const Eigen::Vector3d& knee, const Eigen::Vector3d& ankle) {
    limb({0, 0.19 * y, 1.39}, elbow, 0.05);
    limb(elbow, hand, 0.04);
    limb({0, 0.10 * y, 0.92}, knee, 0.08);
    limb(knee, ankle, 0.055);
    limb(ankle - Eigen::Vector3d(0, 0, 0.04), ankle + Eigen::Vector3d(0.17, 0, -0.05), 0.04);
  };
  side(1.0, pose.left_elbow, pose.left_hand, pose.left_knee, pose.left_ankle);
  side(-1.0, pose.right_elbow, pose.right_hand, pose.right_knee, pose.right_ankle);
}

inline VisualHull personHull(const FigurePose& pose, double pitch) {
  TreeFigure figure(pitch);
  addPerson(pose, Eigen::Vector3d::Zero(), &figure);
  return figure.hull();
}

}  // namespace markerless_mocap
