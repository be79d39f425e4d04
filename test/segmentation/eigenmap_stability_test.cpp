#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "segmentation/box_graph.h"
#include "segmentation/eigenmap.h"
#include "segmentation/graph_modes.h"
#include "segmentation/voxel_figure.h"
#include "segmentation/voxel_graph.h"

namespace markerless_mocap {
namespace {

TEST(LaplacianEigenmap, TakesTheReferenceWhereTheFastWayFails) {
  const WeightedGraph graph = box(20, 12, 5);
  const Eigenmap map = laplacianEigenmap(graph, 4, 1e-12);  // beyond single precision
  EXPECT_LT(map.residuals.maxCoeff(), 1e-4);
  const GraphModes reference = shiftInvertModes(graph, 4);
  EXPECT_TRUE(map.values.isApprox(reference.values, 1e-9));
}

// Cells far apart that are neighbours in the graph: no two nodes share a block.
TEST(LaplacianEigenmap, DoesWithoutUsefulCells) {
  const WeightedGraph graph =
      boxGraph(12, 10, 5, [](int i, int j, int k) { return LatticeCell(40 * i, 40 * j, 40 * k); });
  EXPECT_FALSE(coarseToFineModes(graph, 4, 1e-2).has_value());
  EXPECT_TRUE(laplacianEigenmap(graph, 4).values.isApprox(
      laplacianEigenmap(box(12, 10, 5), 4).values, 1e-4));
}

TEST(LaplacianEigenmap, RefusesAGraphInPieces) {
  const WeightedGraph one = box(9, 9, 9);
  std::vector<Edge> edges;
  for (uint32_t node = 0; node < one.nodeCount(); ++node) {
    for (uint32_t e = one.row_start[node]; e < one.row_start[node + 1]; ++e) {
      if (one.neighbor[e] > node) edges.push_back({node, one.neighbor[e], 1.0});
      if (one.neighbor[e] > node) edges.push_back({node + 729, one.neighbor[e] + 729, 1.0});
    }
  }
  WeightedGraph two = graphOfEdges(2 * 729, edges);
  for (int copy = 0; copy < 2; ++copy) {
    for (uint32_t n = 0; n < 729; ++n) {
      two.cell.emplace_back(int(n % 9) + 20 * copy, int(n / 9 % 9), int(n / 81));
    }
  }
  EXPECT_FALSE(coarseToFineModes(two, 4, 1e-2).has_value());
  try {
    laplacianEigenmap(two, 4);
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "laplacianEigenmap: the graph has 2 components, it must be connected");
  }
  EXPECT_THROW(laplacianEigenmap(graphOfEdges(4, {{0, 1, 1.0}, {2, 3, 1.0}}), 2),
               std::invalid_argument);
}

TEST(LaplacianEigenmap, KnowsTwoNodes) {
  const Eigenmap map = laplacianEigenmap(graphOfEdges(2, {{0, 1, 5.0}}), 3);
  ASSERT_EQ(map.values.size(), 1);
  EXPECT_NEAR(map.values[0], 2.0, 1e-12);
  EXPECT_NEAR(std::abs(map.vectors(0, 0)), 1.0, 1e-12);
  EXPECT_NEAR(map.vectors(0, 0), -map.vectors(1, 0), 1e-12);
}

/// The hull turned by 90 degrees about the vertical and moved by an odd number of voxels.
VisualHull turned(const VisualHull& hull) {
  VisualHull result;
  result.status = hull.status;
  result.lattice = hull.lattice;
  result.lattice.size = {hull.lattice.size.y() + 3, hull.lattice.size.x() + 1,
                         hull.lattice.size.z() + 5};
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3i at = hull.lattice.coordinates(voxel.index);
    HullVoxel moved;
    moved.index =
        result.lattice.index(hull.lattice.size.y() - 1 - at.y() + 3, at.x() + 1, at.z() + 5);
    result.voxels.push_back(moved);
  }
  return result;
}

TEST(LaplacianEigenmap, DoesNotDependOnOrderPlaceOrHeading) {
  const VisualHull hull = standingFigure(1.0).hull();
  VisualHull moved = turned(hull);
  std::reverse(moved.voxels.begin(), moved.voxels.end());
  const VoxelGraph a = buildVoxelGraph(hull);
  const VoxelGraph b = buildVoxelGraph(moved);
  const Eigenmap map = laplacianEigenmap(a.graph, 6, 1e-3);
  const Eigenmap other = laplacianEigenmap(b.graph, 6, 1e-3);
  EXPECT_TRUE(map.values.isApprox(other.values, 1e-5));
  std::vector<uint32_t> node_of(hull.voxels.size());  // in b, by the place in the first hull
  for (uint32_t n = 0; n < b.hull_voxel.size(); ++n) {
    node_of[hull.voxels.size() - 1 - b.hull_voxel[n]] = n;
  }
  Eigen::MatrixXd sorted(map.vectors.rows(), 6);
  for (uint32_t n = 0; n < a.hull_voxel.size(); ++n) {
    sorted.row(n) = other.vectors.row(node_of[a.hull_voxel[n]]);
  }
  const Eigen::VectorXd degree = degreesOf(a.graph);
  const double scale = std::sqrt(degree.sum());
  EXPECT_LT(sineBetween(map.vectors / scale, sorted / scale, degree), 1e-3);
}

/// Mean scalar product of two frames' rows in places both have, of the mean square.
double likeness(const VoxelGraph& a, const Eigenmap& first, const VoxelGraph& b,
                const Eigenmap& second, int mode) {
  double product = 0.0;
  double squares = 0.0;
  for (size_t n = 0; n < a.graph.nodeCount(); ++n) {
    for (size_t m = 0; m < b.graph.nodeCount(); ++m) {
      if (!(a.graph.cell[n] == b.graph.cell[m])) continue;
      const double x = first.vectors(Eigen::Index(n), mode);
      const double y = second.vectors(Eigen::Index(m), mode);
      product += x * y;
      squares += 0.5 * (x * x + y * y);
    }
  }
  return product / squares;
}

TEST(LaplacianEigenmap, KeepsItsSignsFromFrameToFrame) {
  const VoxelGraph a = buildVoxelGraph(standingFigure(1.00).hull());
  const VoxelGraph b = buildVoxelGraph(standingFigure(1.03).hull());
  const Eigenmap first = laplacianEigenmap(a.graph, 6);
  const Eigenmap second = laplacianEigenmap(b.graph, 6);
  for (int mode = 0; mode < 6; ++mode) EXPECT_GT(likeness(a, first, b, second, mode), 0.5);
}

}  // namespace
}  // namespace markerless_mocap
