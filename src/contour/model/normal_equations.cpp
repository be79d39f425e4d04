#include "contour/model/normal_equations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

namespace markerless_mocap {
namespace {

/// The degrees of freedom that move a segment, ascending: half of all or fewer.
struct MovedBy {
  std::array<int, kContourDof> dofs;
  int count = 0;

  explicit MovedBy(uint64_t dof_mask) {
    for (int dof = 0; dof < kContourDof; ++dof)
      if (dof_mask >> dof & 1) dofs[size_t(count++)] = dof;
  }
};

/// d(a, b)/d(degrees of freedom that move the cone), one column for each.
using EndsJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kContourDof>;

/// The columns of poseJacobian() that are not 0, for both ends.
EndsJacobian endsJacobian(const MovedBy& moved, const ContourFrames& frames,
                          const ContourWorldCone& cone) {
  EndsJacobian J(6, moved.count);
  for (int i = 0; i < moved.count; ++i) {
    const int dof = moved.dofs[size_t(i)];
    const Eigen::Vector3d axis = frames.axis.col(dof), pivot = frames.pivot.col(dof);
    const bool turns = dof >= 3;
    J.col(i).head<3>() = turns ? Eigen::Vector3d(axis.cross(cone.a - pivot)) : axis;
    J.col(i).tail<3>() = turns ? Eigen::Vector3d(axis.cross(cone.b - pivot)) : axis;
  }
  return J;
}

/// The equations of the ends alone: a pose changes no radius.
Eigen::Matrix<double, 6, 6> withoutRadii(const Eigen::Matrix<double, 8, 8>& H) {
  Eigen::Matrix<double, 6, 6> out;
  out << H.block<3, 3>(0, 0), H.block<3, 3>(0, 4), H.block<3, 3>(4, 0), H.block<3, 3>(4, 4);
  return out;
}
Eigen::Matrix<double, 6, 1> withoutRadii(const Eigen::Matrix<double, 8, 1>& gradient) {
  Eigen::Matrix<double, 6, 1> out;
  out << gradient.head<3>(), gradient.segment<3>(4);
  return out;
}

}  // namespace

void ConeNormalEquations::clear() {
  std::fill(&products_[0][0], &products_[0][0] + 30, 0.0);
  std::fill(std::begin(gradient_), std::end(gradient_), 0.0);
}

void ConeNormalEquations::add(const ConeNormalEquations& other) {
  for (int part = 0; part < 3; ++part)
    for (int k = 0; k < 10; ++k) products_[part][k] += other.products_[part][k];
  for (int i = 0; i < 8; ++i) gradient_[i] += other.gradient_[i];
}

Eigen::Matrix<double, 8, 8> ConeNormalEquations::hessian() const {
  Eigen::Matrix<double, 8, 8> H;
  for (int part = 0; part < 3; ++part) {
    Eigen::Matrix4d block;
    for (int i = 0, k = 0; i < 4; ++i)
      for (int j = i; j < 4; ++j, ++k) block(i, j) = block(j, i) = products_[part][k];
    if (part == 0) H.topLeftCorner<4, 4>() = block;
    if (part == 1) H.topRightCorner<4, 4>() = H.bottomLeftCorner<4, 4>() = block;
    if (part == 2) H.bottomRightCorner<4, 4>() = block;
  }
  return H;
}

Eigen::Matrix<double, 8, 1> ConeNormalEquations::gradient() const {
  return Eigen::Map<const Eigen::Matrix<double, 8, 1>>(gradient_);
}

void accumulatePoseEquations(const AllConeNormalEquations& sums, const ContourFrames& frames,
                             const ContourWorldCones& cones, PoseNormalEquations& equations) {
  for (size_t c = 0; c < kContourCones; ++c) {
    const int segment = contourKinematicTree().cones[c].ends[0].segment;
    const MovedBy moved(contourKinematicTree().segments[size_t(segment)].dof_mask);
    const EndsJacobian J = endsJacobian(moved, frames, cones[c]);
    const EndsJacobian HJ = withoutRadii(sums[c].hessian()).lazyProduct(J);
    const Eigen::Matrix<double, 6, 1> gradient = withoutRadii(sums[c].gradient());
    for (int i = 0; i < moved.count; ++i) {
      const int row = moved.dofs[size_t(i)];
      equations.g[row] += J.col(i).dot(gradient);
      equations.H(row, row) += J.col(i).dot(HJ.col(i));
      for (int j = 0; j < i; ++j) {
        const int column = moved.dofs[size_t(j)];
        const double product = J.col(i).dot(HJ.col(j));
        equations.H(row, column) += product;
        equations.H(column, row) += product;
      }
    }
  }
}

}  // namespace markerless_mocap
