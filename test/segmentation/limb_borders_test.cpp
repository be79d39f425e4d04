#include "segmentation/limbs/limb_borders.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

using Ways = std::array<std::vector<double>, kPartCount>;
using Borders = std::array<double, kPartCount>;

/// Ways of 10000 nodes: `thin` of them in each tenth of a unit up to `length`, the rest behind it.
std::vector<double> limbOnATrunk(int thin, double length) {
  std::vector<double> geodesic;
  const int stretches = int(length / 0.1 + 0.5);
  for (int i = 0; i < stretches; ++i) geodesic.insert(geodesic.end(), size_t(thin), 0.1 * i + 0.05);
  for (int i = stretches; geodesic.size() < 10000; ++i)
    geodesic.insert(geodesic.end(), 500, 0.1 * i + 0.05);
  geodesic.resize(10000);
  return geodesic;
}

TEST(LimbBorders, LieWhereTheHullWidens) {
  // From 30 to 500 nodes at 1.2: smoothed over three stretches the fronts' middles at 1.15 and 1.25
  // have 147.5 and 382.5; 90, an arm's last front, lies between 30 at 1.05 and 147.5.
  EXPECT_NEAR(limbBorder(PartLabel::kArm1, limbOnATrunk(30, 1.2)),
              1.05 + 0.1 * (90.0 - 30.0) / 117.5, 1e-9);
  // A leg's last front of 320 lies between 222.5 at 2.05 and 407.5 at 2.15.
  EXPECT_NEAR(limbBorder(PartLabel::kLeg2, limbOnATrunk(130, 2.1)),
              2.05 + 0.1 * (320.0 - 222.5) / 185.0, 1e-9);
}

TEST(LimbBorders, LeaveTheNeckToTheHead) {
  const double shoulders = 0.55 + 0.1 * (180.0 - 100.0) / 100.0;  // 200 nodes at 0.65
  EXPECT_NEAR(limbBorder(PartLabel::kHead, limbOnATrunk(100, 0.7)), shoulders - 0.22, 1e-9);
}

TEST(LimbBorders, OfLegsLieAboutHalfwayToTheHead) {
  EXPECT_DOUBLE_EQ(legBorder(2.04, 4.0), 2.04);
  EXPECT_DOUBLE_EQ(legBorder(1.6, 4.0), 0.49 * 4.0) << "thighs that touch";
  EXPECT_DOUBLE_EQ(legBorder(2.6, 4.0), 0.53 * 4.0) << "a skirt";
}

TEST(LimbBorders, TellAWholeLimbFromAStump) {
  EXPECT_TRUE(isWholeLimb(PartLabel::kArm1, 1.2, 0.03));
  EXPECT_FALSE(isWholeLimb(PartLabel::kArm1, 0.6, 0.03)) << "it touches the hip before the elbow";
  EXPECT_FALSE(isWholeLimb(PartLabel::kArm1, 1.5, 0.005)) << "most of it is another's";
}

TEST(LimbBorders, GiveNodesToTheLimbTheyAreFartherInside) {
  Ways geodesic;
  geodesic[size_t(PartLabel::kLeg1)] = {0.0, 1.0, 1.5, 2.5, 1.9};
  geodesic[size_t(PartLabel::kLeg2)] = {3.0, 1.9, 1.2, 2.5, 0.0};
  Borders border{};
  border[size_t(PartLabel::kLeg1)] = border[size_t(PartLabel::kLeg2)] = 2.0;
  const auto nodes = nodesOfLimbs(geodesic, border);
  EXPECT_EQ(nodes[size_t(PartLabel::kLeg1)], (std::vector<uint32_t>{0, 1}));
  EXPECT_EQ(nodes[size_t(PartLabel::kLeg2)], (std::vector<uint32_t>{2, 4}));
  EXPECT_TRUE(nodes[size_t(PartLabel::kHead)].empty());
}

}  // namespace
}  // namespace markerless_mocap
