#include "markerless_mocap/segmentation/part_curve.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "markerless_mocap/segmentation/eigenmap.h"
#include "markerless_mocap/segmentation/least_squares_spline.h"

namespace markerless_mocap {
namespace {

constexpr int kPoints = 21;
constexpr int kPieces = 3;
constexpr int kSamples = 200;      // of the curve, to measure its length by
constexpr double kOutside = 0.03;  // of the nodes, beyond each end of a combination of modes
constexpr size_t kFewestNodes = 8;
constexpr double kResidual = 0.05;  // of the modes: moves a curve by about 1 mm
constexpr size_t kMany = 2000;      // nodes, from which on it moves less
constexpr double kResidualOfMany = 0.15;

/// The combination of the lowest modes that comes nearest to `ahead`.
Eigen::VectorXd modeAlong(const WeightedGraph& part, const Eigen::VectorXd& ahead, int modes) {
  const double residual = part.nodeCount() > kMany ? kResidualOfMany : kResidual;
  const Eigen::MatrixXd vectors = laplacianEigenmap(part, modes, residual).vectors;
  const Eigen::MatrixXd centered = vectors.rowwise() - vectors.colwise().mean();
  const Eigen::VectorXd wanted = ahead.array() - ahead.mean();
  const Eigen::MatrixXd products = centered.transpose() * centered;
  return centered * products.ldlt().solve(centered.transpose() * wanted);
}

/// 0 and 1 where a few nodes are left beyond: the outermost node may be a corner.
Eigen::VectorXd siteValues(const Eigen::VectorXd& mode) {
  std::vector<double> sorted(mode.data(), mode.data() + mode.size());
  std::sort(sorted.begin(), sorted.end());
  const auto outside = size_t(kOutside * double(sorted.size()));
  const double low = sorted[outside];
  const double high = sorted[sorted.size() - 1 - outside];
  return ((mode.array() - low) / std::max(high - low, 1e-12)).max(0.0).min(1.0);
}

void sampleEvenly(const LeastSquaresSpline& spline, PartCurve* curve) {
  std::vector<double> length{0.0};
  for (int i = 1; i <= kSamples; ++i) {
    length.push_back(
        length.back() +
        (spline.at(i / double(kSamples)) - spline.at((i - 1) / double(kSamples))).norm());
  }
  for (int p = 0; p < kPoints; ++p) {
    const double wanted = length.back() * p / (kPoints - 1);
    const auto above = std::lower_bound(length.begin() + 1, length.end() - 1, wanted);
    const double step = *above - *(above - 1);
    const double part = step > 0.0 ? std::min(1.0, (wanted - *(above - 1)) / step) : 0.0;
    const double s = (double(above - length.begin()) - 1.0 + part) / kSamples;
    curve->site_values.push_back(s);
    curve->points.push_back(spline.at(s));
  }
}

}  // namespace

PartCurve fitPartCurve(const VoxelGraph& voxels, const std::vector<uint32_t>& nodes,
                       const std::vector<double>& ahead, int modes) {
  PartCurve curve;
  curve.voxel_count = uint32_t(nodes.size());
  WeightedGraph part = subgraph(voxels.graph, nodes);
  const std::vector<uint32_t> kept = largestComponent(part);
  if (kept.size() < nodes.size()) part = subgraph(part, kept);
  if (kept.size() < kFewestNodes) return curve;
  Eigen::VectorXd along(Eigen::Index(kept.size()));
  Eigen::MatrixXd centers(along.size(), 3);
  for (size_t i = 0; i < kept.size(); ++i) {
    along[Eigen::Index(i)] = ahead[nodes[kept[i]]];
    centers.row(Eigen::Index(i)) = voxels.centers[nodes[kept[i]]].transpose();
  }
  const Eigen::VectorXd mode = modeAlong(part, along, modes);
  const Eigen::VectorXd sites = siteValues(mode);
  sampleEvenly(LeastSquaresSpline(sites, centers, kPieces), &curve);
  curve.seen = true;
  return curve;
}

}  // namespace markerless_mocap
