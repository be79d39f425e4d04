#include "markerless_mocap/segmentation/part_curve.h"

#include <algorithm>
#include <cmath>

#include "markerless_mocap/segmentation/eigenmap.h"
#include "markerless_mocap/segmentation/least_squares_spline.h"

namespace markerless_mocap {
namespace {

constexpr int kPoints = 21;
constexpr int kPieces = 3;
constexpr int kSamples = 200;  // of the curve, to measure its length by
constexpr size_t kFewestNodes = 8;

double correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::VectorXd da = a.array() - a.mean();
  const Eigen::VectorXd db = b.array() - b.mean();
  const double norm = da.norm() * db.norm();
  return norm > 0.0 ? da.dot(db) / norm : 0.0;
}

/// The mode that goes with `ahead` best, with its sign.
Eigen::VectorXd modeAlong(const WeightedGraph& part, const Eigen::VectorXd& ahead, int modes) {
  const Eigenmap map = laplacianEigenmap(part, modes);
  double best = 0.0;
  Eigen::Index chosen = 0;
  for (Eigen::Index mode = 0; mode < map.vectors.cols(); ++mode) {
    const double with = correlation(map.vectors.col(mode), ahead);
    if (std::abs(with) <= std::abs(best)) continue;
    best = with;
    chosen = mode;
  }
  return best < 0.0 ? Eigen::VectorXd(-map.vectors.col(chosen)) : map.vectors.col(chosen);
}

/// 0 at the lowest value of the mode, 1 at the highest.
Eigen::VectorXd siteValues(const Eigen::VectorXd& mode) {
  const double middle = 0.5 * (mode.maxCoeff() + mode.minCoeff());
  const double half = 0.5 * (mode.maxCoeff() - mode.minCoeff());
  const Eigen::ArrayXd cosine = ((mode.array() - middle) / half).max(-1.0).min(1.0);
  return 1.0 - cosine.acos() / std::acos(-1.0);
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
  const WeightedGraph all = subgraph(voxels.graph, nodes);
  const std::vector<uint32_t> kept = largestComponent(all);
  if (kept.size() < kFewestNodes) return curve;
  Eigen::VectorXd along(Eigen::Index(kept.size()));
  Eigen::MatrixXd centers(along.size(), 3);
  for (size_t i = 0; i < kept.size(); ++i) {
    along[Eigen::Index(i)] = ahead[nodes[kept[i]]];
    centers.row(Eigen::Index(i)) = voxels.centers[nodes[kept[i]]].transpose();
  }
  const Eigen::VectorXd mode = modeAlong(subgraph(all, kept), along, modes);
  sampleEvenly(LeastSquaresSpline(siteValues(mode), centers, kPieces), &curve);
  curve.seen = true;
  return curve;
}

}  // namespace markerless_mocap
