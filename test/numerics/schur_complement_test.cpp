#include "numerics/schur_complement.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace markerless_mocap {
namespace {

TEST(SchurComplementTest, GivesTheStepsOfAllEquations) {
  constexpr int kInner = 3, kOuter = 2, kAll = kInner + kOuter;
  Eigen::MatrixXd J(7, kAll);
  for (int i = 0; i < J.rows(); ++i)
    for (int j = 0; j < kAll; ++j) J(i, j) = std::sin(1.0 + (i + 1.0) * (j + 2.0) * (j + 2.0));
  const Eigen::MatrixXd H = J.transpose() * J;
  const Eigen::VectorXd g = J.transpose() * Eigen::VectorXd::LinSpaced(J.rows(), -1.0, 2.0);
  const Eigen::VectorXd step = -Eigen::LLT<Eigen::MatrixXd>(H).solve(g);

  const ReducedNormalEquations reduced({H.topLeftCorner(kInner, kInner), g.head(kInner),
                                        H.topRightCorner(kInner, kOuter),
                                        H.bottomRightCorner(kOuter, kOuter), g.tail(kOuter)});
  const Eigen::VectorXd outer = -Eigen::LLT<Eigen::MatrixXd>(reduced.H()).solve(reduced.g());
  EXPECT_TRUE(outer.isApprox(step.tail(kOuter), 1e-9));
  EXPECT_TRUE(reduced.innerStep(outer).isApprox(step.head(kInner), 1e-9));
}

}  // namespace
}  // namespace markerless_mocap
