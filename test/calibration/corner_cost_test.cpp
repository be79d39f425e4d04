#include "calibration/adjust/corner_cost.h"

#include <gtest/gtest.h>

#include <ceres/autodiff_cost_function.h>

#include <array>

namespace markerless_mocap {
namespace {

void compareDerivatives(LensType type) {
  const CornerResidual corner{{0.3, 0.2}, {400, 300}, {{50, -20}, {30, 90}}, 0.04, type};
  const std::array<double, 12> lens = {800,  820,    640,  360, -0.2, 0.07,
                                       0.01, -0.006, 0.02, 0.1, 0.03, -0.01};
  const std::array<double, 6> camera = {0.4, -1.3, 0.6, 0.2, -0.1, 2.0};
  const std::array<double, 6> board = {-0.2, 0.3, 1.9, 0.1, 0.2, 0.3};
  const double offset = 0.013;
  const double* parameters[] = {lens.data(), camera.data(), board.data(), &offset};
  std::array<std::array<double, 24>, 4> by_hand{}, automatic{};
  double* by_hand_blocks[] = {by_hand[0].data(), by_hand[1].data(), by_hand[2].data(),
                              by_hand[3].data()};
  double* automatic_blocks[] = {automatic[0].data(), automatic[1].data(), automatic[2].data(),
                                automatic[3].data()};
  double r[2], s[2];
  ASSERT_TRUE(CornerCost(corner).Evaluate(parameters, r, by_hand_blocks));
  ceres::AutoDiffCostFunction<CornerResidual, 2, 12, 6, 6, 1> reference(new CornerResidual(corner));
  ASSERT_TRUE(reference.Evaluate(parameters, s, automatic_blocks));
  EXPECT_EQ(r[0], s[0]);
  EXPECT_EQ(r[1], s[1]);
  for (int block = 0; block < 4; ++block)
    for (int i = 0; i < 24; ++i)
      EXPECT_NEAR(by_hand[block][i], automatic[block][i],
                  1e-9 * (1 + std::abs(automatic[block][i])))
          << block << ' ' << i;
}

TEST(CornerCost, DerivativesAreThoseOfTheResidual) {
  compareDerivatives(LensType::kPolynomial);
}

TEST(CornerCost, DerivativesOfAFisheyeAreThoseOfTheResidual) {
  compareDerivatives(LensType::kFisheye);
}

}  // namespace
}  // namespace markerless_mocap
