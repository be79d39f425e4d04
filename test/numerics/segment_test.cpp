#include "numerics/segment.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(Segment, NearestPlaceIsOnItOrAnEnd) {
  const Vector3d start(1, 0, 0), step(4, 0, 0);
  EXPECT_EQ(nearestFraction(Vector3d(2, 3, 0), start, step), 0.25);
  EXPECT_EQ(nearestFraction(Vector3d(-5, 3, 0), start, step), 0.0);
  EXPECT_EQ(nearestFraction(Vector3d(9, 3, 0), start, step), 1.0);
}

TEST(Segment, DistanceIsThatOfTheNearestPlace) {
  EXPECT_EQ(distanceToSegment(Vector2d(2, 3), Vector2d(0, 0), Vector2d(8, 0)), 3.0);
  EXPECT_EQ(distanceToSegment(Vector2d(-3, 4), Vector2d(0, 0), Vector2d(8, 0)), 5.0);
}

TEST(Segment, OneWithoutLengthIsAPoint) {
  EXPECT_EQ(nearestFraction(Vector3d(1, 2, 3), Vector3d(1, 0, 0), Vector3d(0, 0, 0)), 0.0);
  EXPECT_EQ(distanceToSegment(Vector2d(3, 4), Vector2d(0, 0), Vector2d(0, 0)), 5.0);
}

}  // namespace
}  // namespace markerless_mocap
