#include "hsiao/fit/hsiao_skeleton_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "hsiao/synthetic_person.h"
#include "numerics/counter_random.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<bool, kPartCount> kAll = {true, true, true, true, true, true};

TEST(PairedDistance, IsTheMeanOfPointDistances) {
  const Vector3d a[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const Vector3d b[] = {{0, 3, 0}, {1, 0, 4}, {2, 0, 0}};
  EXPECT_DOUBLE_EQ(pairedDistance(a, b, 3), 7.0 / 3.0);
}

TEST(PairedDistance, TakesTheReversedOrderWhenThatIsCloser) {
  const Vector3d a[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const Vector3d b[] = {{2, 1, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_DOUBLE_EQ(pairedDistance(a, b, 3), 1.0);
}

double sumOf(const PartMatrix& error, const PartAssignment& assignment) {
  double sum = 0.0;
  for (int i = 0; i < kPartCount; ++i)
    if (assignment[i] >= 0) sum += error(i, assignment[i]);
  return sum;
}

TEST(AssignParts, AgreesWithTryingEveryOrder) {
  for (int round = 0; round < 50; ++round) {
    PartMatrix error;
    for (int i = 0; i < 36; ++i) error(i / 6, i % 6) = CounterRandom(round).uniform(i);
    PartAssignment order;
    std::iota(order.begin(), order.end(), 0);
    double best = kInfinity;
    do best = std::min(best, sumOf(error, order));
    while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(sumOf(error, assignParts(error)), best, 1e-12);
  }
}

TEST(AssignParts, LeavesOutRowsThatMayGoNowhereAndUsesEachColumnOnce) {
  PartMatrix error = PartMatrix::Constant(kInfinity);
  error(2, 2) = 1.0;
  error(2, 3) = 5.0;
  error(3, 2) = 2.0;
  error(3, 3) = 10.0;
  const PartAssignment assignment = assignParts(error);
  EXPECT_EQ(assignment, (PartAssignment{-1, -1, 3, 2, -1, -1}));
}

class SkeletonErrorTest : public testing::Test {
 protected:
  double errorAt(const BodyParts& parts, const HsiaoVector& v) const {
    HsiaoFrames frames;
    body_model_.frames(v.data(), frames);
    return HsiaoSkeletonError(body_model_, parts, 16)(frames, kAll);
  }
  HsiaoBodyModel body_model_{*testBody()};
};

TEST_F(SkeletonErrorTest, IsZeroAtThePoseThatTheCurvesCameFrom) {
  const HsiaoVector v = stepping(body_model_, 0.7);
  EXPECT_LT(errorAt(curvesOf(body_model_, v), v), 0.005);
}

TEST_F(SkeletonErrorTest, GrowsByTheDistanceThatABodyIsMovedSideways) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  HsiaoVector moved = v;
  moved[1] += 0.1;
  moved[4] += 0.1;
  EXPECT_NEAR(errorAt(curvesOf(body_model_, v), moved), 0.1, 0.005);
}

TEST_F(SkeletonErrorTest, DoesNotMindWhichArmIsCalledFirst) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  BodyParts parts = curvesOf(body_model_, v);
  std::swap(parts.parts[2], parts.parts[3]);
  std::swap(parts.parts[4], parts.parts[5]);
  EXPECT_LT(errorAt(parts, v), 0.005);
}

TEST_F(SkeletonErrorTest, NeverTakesAnArmForALeg) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  BodyParts parts = curvesOf(body_model_, v);
  std::swap(parts.parts[2], parts.parts[4]);
  EXPECT_GT(errorAt(parts, v), 0.1);
}

// Hsiao 2008, 3.2.2.1: the smallest one-to-one sum over all 6 x 6 pairs of whole parts.
TEST_F(SkeletonErrorTest, AsPublishedPairsAnyPartWithAnyAndWholeCurvesWithWholeParts) {
  const HsiaoVector v = stepping(body_model_, 0.4);
  HsiaoFrames frames;
  body_model_.frames(v.data(), frames);
  BodyParts parts = curvesOf(body_model_, v);
  const auto error = [&] { return HsiaoSkeletonError(body_model_, parts, 16, true)(frames, kAll); };
  EXPECT_LT(error(), 0.005);
  std::swap(parts.parts[2], parts.parts[4]);
  EXPECT_LT(error(), 0.005);
  std::vector<Vector3d>& points = parts.parts[2].points;
  points.erase(points.begin(), points.begin() + 8);
  EXPECT_GT(error(), 0.01);
}

TEST_F(SkeletonErrorTest, LeavesOutPartsThatAreNotWhole) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  BodyParts parts = curvesOf(body_model_, v);
  for (Vector3d& point : parts.parts[2].points) point.z() += 1.0;
  const double with = errorAt(parts, v);
  parts.parts[2].whole = false;
  EXPECT_GT(with, 0.1);
  EXPECT_LT(errorAt(parts, v), 0.005);
}

TEST_F(SkeletonErrorTest, AcceptsAnArmThatBeginsLate) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  BodyParts parts = curvesOf(body_model_, v);
  std::vector<Vector3d>& points = parts.parts[2].points;
  points.erase(points.begin(), points.begin() + 6);
  EXPECT_LT(errorAt(parts, v), 0.005);
}

}  // namespace
}  // namespace markerless_mocap
