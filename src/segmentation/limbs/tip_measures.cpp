#include "segmentation/limbs/tip_measures.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kFullnessRadius = 0.6;  // units: about a head's length

}  // namespace

TipMeasures measureTips(const VoxelGraph& voxels, const std::vector<uint32_t>& tips,
                        const std::vector<uint32_t>& core) {
  const auto nodes = double(voxels.graph.nodeCount());
  const double unit = std::cbrt(nodes);  // in voxels
  const auto logarithm = [&](double length) { return std::log(std::max(length, 1.0 / unit)); };
  const auto higher = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.z() < b.z();
  };
  const auto [low, high] =
      std::minmax_element(voxels.centers.begin(), voxels.centers.end(), higher);
  const double lowest = low->z(), tall = std::max(high->z() - lowest, voxels.pitch);
  TipMeasures measures;
  measures.distance = Eigen::MatrixXd::Zero(tips.size(), tips.size());
  measures.way = voxels.grid.geodesicsOfEach(tips);
  for (size_t i = 0; i < tips.size(); ++i) {
    std::vector<double>& way = measures.way[i];
    for (double& w : way) w /= unit;
    double to_core = way[core.front()];
    for (const uint32_t node : core) to_core = std::min(to_core, way[node]);
    const auto near =
        std::count_if(way.begin(), way.end(), [](double w) { return w <= kFullnessRadius; });
    measures.to_core.push_back(logarithm(to_core));
    measures.height.push_back((voxels.centers[tips[i]].z() - lowest) / tall);
    measures.fullness.push_back(std::log(double(near) / nodes));
    for (size_t j = 0; j < i; ++j) {
      measures.distance(i, j) = measures.distance(j, i) = logarithm(way[tips[j]]);
    }
  }
  return measures;
}

}  // namespace markerless_mocap
