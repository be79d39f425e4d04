/// The eigenmap of a body's voxel graph against Spectra's shift-and-invert solver with Eigen's
/// sparse Cholesky decomposition, and the whole segmentation. All are told in one run: the ratio is
/// the result.

#include <benchmark/benchmark.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "markerless_mocap/segmentation/body_segmenter.h"
#include "segmentation/eigenmap.h"
#include "segmentation/graph_modes.h"
#include "segmentation/voxel_graph.h"

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

void eigenmapReference(benchmark::State& state) {
  const VoxelGraph voxels = buildVoxelGraph(bodyHull(pitchOf(state)));
  for (auto _ : state) benchmark::DoNotOptimize(shiftInvertModes(voxels.graph, kModes));
}

/// Sine of the largest angle between our space and the reference's.
double sineToReference(const WeightedGraph& graph, int modes) {
  const Eigen::VectorXd degree = degreesOf(graph);
  const Eigen::MatrixXd ours =
      laplacianEigenmap(graph, kModes).vectors.leftCols(modes) / std::sqrt(degree.sum());
  const Eigen::MatrixXd theirs = shiftInvertModes(graph, kModes).vectors.leftCols(modes);
  const Eigen::MatrixXd rest = ours - theirs * (theirs.transpose() * degree.asDiagonal() * ours);
  const Eigen::MatrixXd squares = rest.transpose() * degree.asDiagonal() * rest;
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(squares).eigenvalues().maxCoeff());
}

void eigenmapOurs(benchmark::State& state) {
  const VoxelGraph voxels = buildVoxelGraph(bodyHull(pitchOf(state)));
  for (auto _ : state) benchmark::DoNotOptimize(laplacianEigenmap(voxels.graph, kModes));
  state.counters["nodes"] = double(voxels.graph.nodeCount());
  state.counters["sine6"] = sineToReference(voxels.graph, 6);
  state.counters["sine10"] = sineToReference(voxels.graph, kModes);
}

void buildGraph(benchmark::State& state) {
  const VisualHull hull = bodyHull(pitchOf(state));
  for (auto _ : state) benchmark::DoNotOptimize(buildVoxelGraph(hull));
}

void segmentBody(benchmark::State& state) {
  const VisualHull hull = bodyHull(pitchOf(state));
  const BodySegmenter segmenter{SegmentationOptions()};
  for (auto _ : state) benchmark::DoNotOptimize(segmenter.segment(hull));
}

BENCHMARK(eigenmapReference)->Arg(30)->Arg(15)->Unit(benchmark::kMillisecond);
BENCHMARK(eigenmapOurs)->Arg(30)->Arg(15)->Unit(benchmark::kMillisecond);
BENCHMARK(buildGraph)->Arg(30)->Arg(15)->Unit(benchmark::kMillisecond);
BENCHMARK(segmentBody)->Arg(30)->Arg(15)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace markerless_mocap
