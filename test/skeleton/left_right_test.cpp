#include "skeleton/labelling/left_right.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

NodePath between(const std::vector<Eigen::Vector3d>& corners) {
  NodePath path;
  for (size_t i = 0; i + 1 < corners.size(); ++i)
    for (int s = 0; s < 20; ++s)
      path.push_back(corners[i] + s / 20.0 * (corners[i + 1] - corners[i]));
  path.push_back(corners.back());
  return path;
}

/// Faces +x with bent knees; limb 1 is the left one (+y).
BodyPaths crouching() {
  BodyPaths body;
  body.longest = 2.0;
  for (const int i : {0, 1}) {
    const double y = i == 0 ? 0.12 : -0.12;
    body.legs[i] = between({{0.14, y, 0.03}, {0.0, y, 0.07}, {0.12, y, 0.42}, {-0.05, y, 0.75}});
    body.own_legs[i] = body.legs[i];
    body.arms[i] = between({{0.1, 4 * y, 1.0}, {0.0, 3 * y, 1.2}, {0.0, 0.0, 1.25}});
  }
  body.torso = between({{-0.05, 0, 0.85}, {0.02, 0, 1.25}});
  return body;
}

TEST(LeftRight, LineIsFoundAndPointsToTheLastPoint) {
  const Eigen::Vector3d direction = lineDirection(between({{1, 1, 1}, {1, 0, 1}}));
  EXPECT_NEAR((direction - Eigen::Vector3d(0, -1, 0)).norm(), 0.0, 1e-9);
  EXPECT_TRUE(lineDirection({{1, 2, 3}}).isZero());
}

TEST(LeftRight, StretchIsCutByWayFromTheEnd) {
  const NodePath path = between({{0, 0, 0}, {0, 0, 1}});
  const NodePath middle = pathSection(path, 0.25, 0.5);
  EXPECT_NEAR(middle.front().z(), 0.25, 0.051);
  EXPECT_NEAR(middle.back().z(), 0.5, 0.051);
}

TEST(LeftRight, BentLegsTellForward) {
  const BodyAxes axes = findAxes(crouching(), {});
  ASSERT_TRUE(axes.known);
  EXPECT_GT(axes.forward.x(), 0.9);
  EXPECT_GT(axes.left.y(), 0.9);
  EXPECT_NEAR(axes.left.norm(), 1.0, 1e-9);
}

TEST(LeftRight, BothRulesNameTheLimbs) {
  BodyPaths body = crouching();
  const BodyAxes axes = findAxes(body, {});
  EXPECT_TRUE(firstIsLeftByAngles(body.arms, 0.1, body, axes));
  EXPECT_GT(leftOffset(body.arms[0], body.arms[1], axes), 0.1);
  EXPECT_GT(leftOffset(body.own_legs[0], body.own_legs[1], axes), 0.1);
  std::swap(body.arms[0], body.arms[1]);
  EXPECT_FALSE(firstIsLeftByAngles(body.arms, 0.1, body, axes));
  EXPECT_LT(leftOffset(body.arms[0], body.arms[1], axes), -0.1);
}

TEST(LeftRight, ShoulderVectorsOnOneSideAreToldByTheAngleToForward) {
  const BodyPaths body = crouching();
  const BodyAxes axes = findAxes(body, {});
  const NodePath both[2] = {between({{-0.3, 0.4, 1.2}, {0, 0, 1.2}}),
                            between({{0.3, 0.4, 1.2}, {0, 0, 1.2}})};
  EXPECT_TRUE(firstIsLeftByAngles(both, 0.3, body, axes));  // Algorithm 6, step 5
}

TEST(LeftRight, StraightLegsWithoutFeetTellNothing) {
  BodyPaths body = crouching();
  for (NodePath& leg : body.legs) leg = between({{0, 0.1, 0.0}, {0, 0.1, 0.8}});
  EXPECT_FALSE(findAxes(body, {}).known);
}

}  // namespace
}  // namespace markerless_mocap
