#include "hsiao/fit/hull_distance_field.h"

#include <gtest/gtest.h>

#include "error_text_of.h"
#include "hsiao/fit/hull_agreement.h"
#include "hsiao/synthetic_person.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

TEST(SquaredDistanceTransform, EqualsTheNearestOfAllCells) {
  const Eigen::Vector3i size(7, 5, 6);
  std::vector<float> values(size.prod(), 1e10f);
  const std::vector<int> sources = {0, 57, 133, 209};
  for (const int s : sources) values[s] = 0.0f;
  squaredDistanceTransform(values, size);
  const auto at = [&](int i) { return Eigen::Vector3i(i % 7, i / 7 % 5, i / 35); };
  for (int i = 0; i < size.prod(); ++i) {
    int nearest = 1 << 30;
    for (const int s : sources) nearest = std::min(nearest, (at(i) - at(s)).squaredNorm());
    ASSERT_EQ(values[i], float(nearest)) << "cell " << i;
  }
}

VisualHull boxHull() {
  VisualHull hull;
  hull.status = HullStatus::kOk;
  hull.lattice.pitch = 0.1;
  hull.lattice.size = {20, 20, 20};
  for (int k = 5; k < 15; ++k)
    for (int j = 5; j < 15; ++j)
      for (int i = 5; i < 15; ++i) {
        HullVoxel voxel;
        voxel.index = hull.lattice.index(i, j, k);
        hull.voxels.push_back(voxel);
      }
  return hull;  // 1 m cube from 0.5 to 1.5
}

TEST(HullDistanceField, MeasuresTheWayToTheFacesOfABox) {
  const HullDistanceField field(boxHull());
  EXPECT_NEAR(field.signedDistance({1.75, 1.05, 1.05}), 0.25, 1e-6);
  EXPECT_NEAR(field.signedDistance({1.35, 1.05, 1.05}), -0.15, 1e-6);
  EXPECT_NEAR(field.signedDistance({1.5, 1.05, 1.05}), 0.0, 1e-6);
}

TEST(HullDistanceField, GrowsOnBeyondItsGrid) {
  const HullDistanceField field(boxHull());
  EXPECT_NEAR(field.signedDistance({9.05, 1.05, 1.05}), 7.55, 0.06);
}

TEST(HullDistanceField, NoPointHasNoDistance) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const HullDistanceField field(boxHull());
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3d point(1.5, 1.05, 1.05);
    point[axis] = nan;
    EXPECT_TRUE(std::isnan(field.signedDistance(point)));
  }
}

TEST(HullDistanceField, HullsWithoutVoxelsOrOfAHugeBoxAreRefused) {
  EXPECT_THROW(HullDistanceField{VisualHull()}, std::invalid_argument);
  VisualHull hull;
  hull.lattice.size = {64000000, 1, 1};
  hull.voxels.resize(2);
  hull.voxels[1].index = 63999999;
  EXPECT_EQ(errorTextOf([&] { HullDistanceField{hull}; }),
            "the hull lies in a box of 18496 million voxels, allowed are 200 million");
}

TEST(HullDistanceField, SurfaceVoxelsAreThoseWithAFreeSide) {
  EXPECT_EQ(HullDistanceField(boxHull()).surface().size(), 1000u - 512u);
}

class HullAgreementTest : public testing::Test {
 protected:
  HullAgreement measure(const HsiaoVector& body, const VisualHull& hull) const {
    HsiaoFrames frames;
    body_model_.frames(body.data(), frames);
    return measureHullAgreement(shape_, frames, hull, HullDistanceField(hull), 0.04);
  }
  HsiaoBodyModel body_model_{*testBody()};
  HsiaoBodyShape shape_{*testBody(), body_model_};
};

TEST_F(HullAgreementTest, ABodyAgreesWithItsOwnHull) {
  const HsiaoVector v = stepping(body_model_, 0.3);
  const HullAgreement agreement = measure(v, hullOf(body_model_, shape_, v));
  EXPECT_EQ(agreement.hull_explained, 1.0);
  EXPECT_GT(agreement.body_in_hull, 0.97);
}

TEST_F(HullAgreementTest, ABodyBesideTheHullExplainsNothing) {
  HsiaoVector v = stepping(body_model_, 0.3);
  const VisualHull hull = hullOf(body_model_, shape_, v);
  v[1] += 2.0;
  v[4] += 2.0;
  const HullAgreement agreement = measure(v, hull);
  EXPECT_EQ(agreement.hull_explained, 0.0);
  EXPECT_EQ(agreement.body_in_hull, 0.0);
}

TEST(HsiaoWorldCone, DistanceToACapsuleIsExact) {
  const HsiaoWorldCone cone{Vector3d(0, 0, 0), Vector3d(0, 0, 2), 0.25, 0.1, 0.0};
  EXPECT_NEAR(cone.signedDistance({0.5, 0, 1}), 0.4, 1e-12);
  EXPECT_NEAR(cone.signedDistance({0, 0, 2.5}), 0.4, 1e-12);
  EXPECT_NEAR(cone.signedDistance({0, 0, 1}), -0.1, 1e-12);
}

}  // namespace
}  // namespace markerless_mocap
