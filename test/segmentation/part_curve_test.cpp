#include "segmentation/curves/part_curve.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "segmentation/curves/least_squares_spline.h"
#include "voxel_figure.h"

namespace markerless_mocap {
namespace {

TEST(LeastSquaresSpline, GivesACubicBack) {
  const auto cubic = [](double s) { return Eigen::Vector2d(1 + 2 * s - s * s * s, s * s - 0.5); };
  Eigen::VectorXd sites = Eigen::VectorXd::LinSpaced(60, 0.0, 1.0);
  Eigen::MatrixXd values(60, 2);
  for (int i = 0; i < 60; ++i) values.row(i) = cubic(sites[i]).transpose();
  const LeastSquaresSpline spline(sites, values, 4);
  for (const double s : {0.0, 0.13, 0.5, 0.77, 1.0}) {
    EXPECT_LT((spline.at(s) - cubic(s)).norm(), 1e-3);
  }
}

TEST(LeastSquaresSpline, ContinuesAcrossAGap) {
  Eigen::VectorXd sites(40);
  for (int i = 0; i < 40; ++i) sites[i] = i < 20 ? i * 0.01 : 0.8 + (i - 20) * 0.01;
  const Eigen::MatrixXd values = 3.0 * sites;  // a line without its middle
  EXPECT_NEAR(LeastSquaresSpline(sites, values, 8).at(0.5)[0], 1.5, 1e-2);
}

TEST(LeastSquaresSpline, TakesAWeightForSoManyEqualValues) {
  const Eigen::VectorXd sites = Eigen::VectorXd::LinSpaced(5, 0.0, 1.0);
  const Eigen::VectorXd values = (3.0 * sites.array()).sin();
  Eigen::VectorXd repeated_sites(8), repeated(8);
  repeated_sites << sites, sites[1], sites[1], sites[3];
  repeated << values, values[1], values[1], values[3];
  Eigen::VectorXd weights(5);
  weights << 1, 3, 1, 2, 1;
  const LeastSquaresSpline one(sites, values, weights, 1), other(repeated_sites, repeated, 1);
  for (const double s : {0.0, 0.4, 1.0}) EXPECT_NEAR(one.at(s)[0], other.at(s)[0], 1e-9);
}

std::vector<uint32_t> allNodes(const VoxelGraph& voxels) {
  std::vector<uint32_t> nodes(voxels.graph.nodeCount());
  std::iota(nodes.begin(), nodes.end(), 0u);
  return nodes;
}

double lengthOf(const PartCurve& curve) {
  double length = 0.0;
  for (size_t i = 1; i < curve.points.size(); ++i) {
    length += (curve.points[i] - curve.points[i - 1]).norm();
  }
  return length;
}

TEST(PartCurve, TurnsACornerWithManyPieces) {
  // A shank and a foot of the same thickness.
  VoxelFigure figure;
  figure.capsule({0, 0, 1.0}, {0, 0, 0.1}, 0.05).capsule({0, 0, 0.1}, {0, 0.3, 0.1}, 0.05);
  const VoxelGraph voxels = buildVoxelGraph(figure.hull());
  std::vector<double> ahead;
  for (const Eigen::Vector3d& center : voxels.centers) ahead.push_back(center.y() - center.z());
  const auto farthestOff = [&](int pieces) {
    double farthest = 0.0;
    for (const Eigen::Vector3d& p : fitPartCurve(voxels, allNodes(voxels), ahead, 3, pieces).points)
      farthest =
          std::max(farthest, std::min(std::hypot(p.x(), p.y()), std::hypot(p.x(), p.z() - 0.1)));
    return farthest;
  };
  EXPECT_LT(farthestOff(5), 0.03);
  EXPECT_GT(farthestOff(1), farthestOff(5));
}

TEST(PartCurve, RunsAlongTheAxisOfABarInTheGivenDirection) {
  VoxelFigure bar;
  bar.capsule({-0.4, 0, 0.5}, {0.4, 0, 0.9}, 0.06);
  const VoxelGraph voxels = buildVoxelGraph(bar.hull());
  std::vector<double> ahead;
  for (const Eigen::Vector3d& c : voxels.centers) ahead.push_back(-c.x());
  const PartCurve curve = fitPartCurve(voxels, allNodes(voxels), ahead, 3, 3);
  ASSERT_TRUE(curve.seen);
  EXPECT_EQ(curve.voxel_count, voxels.graph.nodeCount());
  ASSERT_EQ(curve.points.size(), 21u);
  EXPECT_LT((curve.points.front() - Eigen::Vector3d(0.4, 0, 0.9)).norm(), 0.06);
  EXPECT_LT((curve.points.back() - Eigen::Vector3d(-0.4, 0, 0.5)).norm(), 0.06);
  const Eigen::Vector3d axis = Eigen::Vector3d(0.8, 0, 0.4).normalized();
  for (const Eigen::Vector3d& p : curve.points) {
    EXPECT_LT((p - Eigen::Vector3d(0, 0, 0.7)).cross(axis).norm(), 0.012);
  }
}

TEST(PartCurve, HasEvenlySpacedPointsAndRisingSites) {
  VoxelFigure elbow;
  elbow.capsule({-0.4, 0, 0.5}, {0, 0, 0.5}, 0.05).capsule({0, 0, 0.5}, {0, 0, 0.9}, 0.05);
  const VoxelGraph voxels = buildVoxelGraph(elbow.hull());
  std::vector<double> ahead;
  for (const Eigen::Vector3d& c : voxels.centers) ahead.push_back(c.x() + c.z());
  const PartCurve curve = fitPartCurve(voxels, allNodes(voxels), ahead, 3, 3);
  ASSERT_EQ(curve.site_values.size(), curve.points.size());
  EXPECT_EQ(curve.site_values.front(), 0.0);
  EXPECT_EQ(curve.site_values.back(), 1.0);
  const double step = lengthOf(curve) / 20.0;
  for (size_t i = 1; i < curve.points.size(); ++i) {
    EXPECT_GT(curve.site_values[i], curve.site_values[i - 1]);
    EXPECT_NEAR((curve.points[i] - curve.points[i - 1]).norm(), step, 0.05 * step);
    const Eigen::Vector3d& p = curve.points[i];
    EXPECT_LT(std::min(std::hypot(p.y(), p.z() - 0.5), std::hypot(p.x(), p.y())), 0.05);
  }
}

TEST(PartCurve, GoesUpATrunkWiderThanHigh) {
  VoxelFigure trunk;
  trunk.capsule({-0.4, 0, 0.8}, {0.4, 0, 0.8}, 0.15).capsule({-0.4, 0, 0.9}, {0.4, 0, 0.9}, 0.15);
  const VoxelGraph voxels = buildVoxelGraph(trunk.hull());
  std::vector<double> ahead;
  for (const Eigen::Vector3d& c : voxels.centers) ahead.push_back(c.z());
  const PartCurve curve = fitPartCurve(voxels, allNodes(voxels), ahead, 10, 3);
  EXPECT_GT(curve.points.back().z() - curve.points.front().z(), 0.25);
  for (const Eigen::Vector3d& p : curve.points) EXPECT_LT(std::abs(p.x()), 0.06);
}

// A finer hull is merged into blocks on the way: the curve hardly moves.
TEST(PartCurve, IsThatOfACoarseHullOnAFineOne) {
  std::array<PartCurve, 2> curves;
  for (const int fine : {0, 1}) {
    VoxelFigure elbow(fine ? 0.01 : 0.02);
    elbow.capsule({-0.4, 0, 0.5}, {0, 0, 0.5}, 0.06).capsule({0, 0, 0.5}, {0, 0, 0.9}, 0.06);
    const VoxelGraph voxels = buildVoxelGraph(elbow.hull());
    std::vector<double> ahead;
    for (const Eigen::Vector3d& c : voxels.centers) ahead.push_back(c.x() + c.z());
    curves[fine] = fitPartCurve(voxels, allNodes(voxels), ahead, 3, 3);
    ASSERT_TRUE(curves[fine].seen);
    EXPECT_EQ(curves[fine].voxel_count, voxels.graph.nodeCount());
  }
  for (size_t i = 0; i < curves[0].points.size(); ++i) {
    EXPECT_LT((curves[0].points[i] - curves[1].points[i]).norm(), 0.01);
  }
}

TEST(PartCurve, OfTooFewNodesIsNotSeen) {
  VoxelFigure speck;
  speck.capsule({0, 0, 0.5}, {0.06, 0, 0.5}, 0.02);
  const VoxelGraph voxels = buildVoxelGraph(speck.hull());
  ASSERT_LT(voxels.graph.nodeCount(), 8u);
  const std::vector<double> ahead(voxels.graph.nodeCount(), 0.0);
  const PartCurve curve = fitPartCurve(voxels, allNodes(voxels), ahead, 3, 3);
  EXPECT_FALSE(curve.seen);
  EXPECT_TRUE(curve.points.empty());
}

}  // namespace
}  // namespace markerless_mocap
