#include "contour/model/normal_equations.h"

#include <algorithm>
#include <iterator>

namespace markerless_mocap {

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
  Eigen::Matrix<double, 8, kContourDof> J;
  for (size_t c = 0; c < kContourCones; ++c) {
    const int segment = contourKinematicTree().cones[c].ends[0].segment;
    J.row(3).setZero();
    J.row(7).setZero();
    poseJacobian(frames, segment, cones[c].a, J.topRows<3>());
    poseJacobian(frames, segment, cones[c].b, J.middleRows<3>(4));
    const Eigen::Matrix<double, 8, kContourDof> HJ = sums[c].hessian() * J;
    equations.H.noalias() += J.transpose() * HJ;
    equations.g.noalias() += J.transpose() * sums[c].gradient();
  }
}

}  // namespace markerless_mocap
