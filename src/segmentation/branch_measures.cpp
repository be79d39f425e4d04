#include "markerless_mocap/segmentation/branch_measures.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

double meanDepth(const VoxelGraph& voxels, const Branch& branch) {
  double sum = 0.0;
  for (const uint32_t node : branch.nodes) sum += voxels.depth[node];
  return sum / double(branch.nodes.size());
}

}  // namespace

BranchMeasures measureBranches(const VoxelGraph& voxels, const std::vector<Branch>& branches,
                               const std::vector<uint32_t>& core) {
  const auto nodes = double(voxels.graph.nodeCount());
  const double unit = std::cbrt(nodes);  // voxels along the edge of a cube of the hull's volume
  const auto relative = [&](double length) { return std::log(std::max(length, 1.0) / unit); };
  BranchMeasures measures;
  measures.tip_distance = Eigen::MatrixXd::Zero(branches.size(), branches.size());
  for (size_t i = 0; i < branches.size(); ++i) {
    measures.from_tip.push_back(voxels.grid.geodesics({branches[i].tip}));
    const std::vector<double>& way = measures.from_tip.back();
    double to_core = way[core.front()];
    for (const uint32_t node : core) to_core = std::min(to_core, way[node]);
    measures.own.push_back({std::log(double(branches[i].nodes.size()) / nodes), relative(to_core),
                            std::log(meanDepth(voxels, branches[i]) / (voxels.pitch * unit))});
    for (size_t j = 0; j < i; ++j) {
      measures.tip_distance(i, j) = measures.tip_distance(j, i) = relative(way[branches[j].tip]);
    }
  }
  return measures;
}

}  // namespace markerless_mocap
