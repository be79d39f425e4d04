/// The eigenmap of a body's voxel graph against Spectra's shift-and-invert solver as shipped
/// (SparseLU), and the whole segmentation. All are told in one run: the ratio is the result.

#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "markerless_mocap/segmentation/body_segmenter.h"
#include "markerless_mocap/segmentation/eigenmap.h"
#include "markerless_mocap/segmentation/voxel_graph.h"

namespace markerless_mocap {
namespace {

constexpr int kModes = 10;

/// A body of capsules with its arms away from it, 80 litres.
bool insideBody(const Eigen::Vector3d& p) {
  struct Capsule {
    Eigen::Vector3d from, to;
    double radius;
  };
  // Limbs on one side; the other is the mirror image.
  static const std::array<Capsule, 7> kBody = {{{{0, 0, 1.52}, {0, 0, 1.46}, 0.06},
                                                {{0, 0, 1.65}, {0, 0, 1.61}, 0.09},
                                                {{0.04, 0, 0.9}, {0.04, 0, 1.28}, 0.125},
                                                {{0, 0, 1.38}, {0.25, 0, 1.34}, 0.06},
                                                {{0.25, 0, 1.34}, {0.7, 0, 0.9}, 0.045},
                                                {{0.12, 0, 0.8}, {0.16, 0, 0.46}, 0.08},
                                                {{0.16, 0, 0.46}, {0.18, 0, 0.05}, 0.055}}};
  const Eigen::Vector3d q(std::abs(p.x()), p.y(), p.z());
  return std::any_of(kBody.begin(), kBody.end(), [&](const Capsule& capsule) {
    const Eigen::Vector3d axis = capsule.to - capsule.from;
    const double t = std::clamp((q - capsule.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    return (q - capsule.from - t * axis).norm() <= capsule.radius;
  });
}

VisualHull bodyHull(double pitch) {
  VisualHull hull;
  hull.status = HullStatus::kOk;
  hull.lattice.origin = {-1.0, -0.5, 0.0};
  hull.lattice.pitch = pitch;
  hull.lattice.size = (Eigen::Vector3d(2.0, 1.0, 1.8) / pitch).cast<int>();
  for (uint32_t index = 0; index < hull.lattice.count(); ++index) {
    if (!insideBody(hull.lattice.center(index))) continue;
    HullVoxel voxel;
    voxel.index = index;
    hull.voxels.push_back(voxel);
  }
  return hull;
}

double pitchOf(const benchmark::State& state) {
  return double(state.range(0)) / 1000.0;
}

void eigenmapOurs(benchmark::State& state) {
  const VoxelGraph voxels = buildVoxelGraph(bodyHull(pitchOf(state)), false, 0.0);
  for (auto _ : state) benchmark::DoNotOptimize(laplacianEigenmap(voxels.graph, kModes));
  state.counters["nodes"] = double(voxels.graph.nodeCount());
}

Eigen::SparseMatrix<double> normalizedLaplacian(const WeightedGraph& graph) {
  const auto nodes = Eigen::Index(graph.nodeCount());
  Eigen::VectorXd degree = Eigen::VectorXd::Zero(nodes);
  std::vector<Eigen::Triplet<double>> entries;
  for (uint32_t i = 0; i < nodes; ++i) {
    for (uint32_t e = graph.row_start[i]; e < graph.row_start[i + 1]; ++e) {
      degree[i] += graph.weight[e];
    }
  }
  for (uint32_t i = 0; i < nodes; ++i) {
    entries.emplace_back(i, i, 1.0);
    for (uint32_t e = graph.row_start[i]; e < graph.row_start[i + 1]; ++e) {
      const uint32_t j = graph.neighbor[e];
      entries.emplace_back(i, j, -graph.weight[e] / std::sqrt(degree[i] * degree[j]));
    }
  }
  Eigen::SparseMatrix<double> matrix(nodes, nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void eigenmapReference(benchmark::State& state) {
  const VoxelGraph voxels = buildVoxelGraph(bodyHull(pitchOf(state)), false, 0.0);
  for (auto _ : state) {
    const Eigen::SparseMatrix<double> matrix = normalizedLaplacian(voxels.graph);
    Spectra::SparseSymShiftSolve<double> inverse(matrix);
    Spectra::SymEigsShiftSolver<Spectra::SparseSymShiftSolve<double>> solver(
        inverse, kModes + 1, 2 * kModes + 10, -1e-5);
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 300, 1e-6);
    benchmark::DoNotOptimize(solver.eigenvectors());
  }
}

void segmentBody(benchmark::State& state) {
  const VisualHull hull = bodyHull(pitchOf(state));
  const BodySegmenter segmenter{SegmentationOptions()};
  for (auto _ : state) benchmark::DoNotOptimize(segmenter.segment(hull));
}

BENCHMARK(eigenmapReference)->Arg(30)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(eigenmapOurs)->Arg(30)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(segmentBody)->Arg(30)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace markerless_mocap
