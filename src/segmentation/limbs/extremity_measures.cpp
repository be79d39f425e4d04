#include "segmentation/limbs/extremity_measures.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kFullnessRadius = 0.6;  // units; about the length of a head

}  // namespace

ExtremityMeasures measureExtremities(const VoxelGraph& voxels,
                                     const std::vector<uint32_t>& extremities,
                                     const std::vector<uint32_t>& core) {
  const auto nodes = double(voxels.graph.nodeCount());
  const double unit = std::cbrt(nodes);  // voxels
  const auto logarithm = [&](double length) { return std::log(std::max(length, 1.0 / unit)); };
  const auto higher = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.z() < b.z();
  };
  const auto [low, high] =
      std::minmax_element(voxels.centers.begin(), voxels.centers.end(), higher);
  const double lowest = low->z(), tall = std::max(high->z() - lowest, voxels.pitch);
  ExtremityMeasures measures;
  measures.distance = Eigen::MatrixXd::Zero(extremities.size(), extremities.size());
  measures.geodesic = voxels.grid.geodesicsOfEach(extremities);
  for (size_t i = 0; i < extremities.size(); ++i) {
    std::vector<double>& geodesic = measures.geodesic[i];
    for (double& w : geodesic) w /= unit;
    double to_core = geodesic[core.front()];
    for (const uint32_t node : core) to_core = std::min(to_core, geodesic[node]);
    const auto near = std::count_if(geodesic.begin(), geodesic.end(),
                                    [](double w) { return w <= kFullnessRadius; });
    measures.to_core.push_back(logarithm(to_core));
    measures.height.push_back((voxels.centers[extremities[i]].z() - lowest) / tall);
    measures.fullness.push_back(std::log(double(near) / nodes));
    for (size_t j = 0; j < i; ++j) {
      measures.distance(i, j) = measures.distance(j, i) = logarithm(geodesic[extremities[j]]);
    }
  }
  return measures;
}

}  // namespace markerless_mocap
