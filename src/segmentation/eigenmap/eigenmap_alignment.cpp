#include "segmentation/eigenmap_alignment.h"

#include <Eigen/SVD>
#include <algorithm>
#include <map>

namespace markerless_mocap {
namespace {

constexpr double kNear = 0.05;  // maximum relative distance of values in one cluster

/// Mean row of the nodes in each block of 4 x 4 x 4 cells; between two frames a limb moves less
/// than such a block.
std::map<uint64_t, Eigen::RowVectorXd> meanRows(const WeightedGraph& graph,
                                                const Eigen::MatrixXd& vectors) {
  std::map<uint64_t, Eigen::RowVectorXd> sums;
  std::map<uint64_t, int> counts;
  for (size_t node = 0; node < graph.cell.size(); ++node) {
    const uint64_t block = graph.cell[node].block().block().packed();
    const auto found = sums.try_emplace(block, Eigen::RowVectorXd::Zero(vectors.cols())).first;
    found->second += vectors.row(Eigen::Index(node));
    ++counts[block];
  }
  for (auto& [block, sum] : sums) sum /= counts[block];
  return sums;
}

/// Products of this frame's columns (rows of the result) with the previous ones.
Eigen::MatrixXd overlap(const WeightedGraph& previous_graph, const Eigen::MatrixXd& previous,
                        const WeightedGraph& graph, const Eigen::MatrixXd& vectors) {
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(vectors.cols(), previous.cols());
  const auto before = meanRows(previous_graph, previous);
  for (const auto& [block, row] : meanRows(graph, vectors)) {
    const auto found = before.find(block);
    if (found != before.end()) products += row.transpose() * found->second;
  }
  return products;
}

}  // namespace

void alignEigenmap(const WeightedGraph& previous_graph, const Eigenmap& previous,
                   const WeightedGraph& graph, Eigenmap* map) {
  const Eigen::Index count = std::min(map->values.size(), previous.values.size());
  const Eigen::MatrixXd products = overlap(previous_graph, previous.vectors, graph, map->vectors);
  for (Eigen::Index from = 0, to = 0; from < count; from = to) {
    to = from + 1;
    while (to < count && map->values[to] <= (1.0 + kNear) * map->values[to - 1]) ++to;
    const Eigen::MatrixXd cluster = products.block(from, from, to - from, to - from);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(cluster, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::MatrixXd turn = svd.matrixU() * svd.matrixV().transpose();
    map->vectors.middleCols(from, to - from) =
        (map->vectors.middleCols(from, to - from) * turn).eval();
  }
}

}  // namespace markerless_mocap
