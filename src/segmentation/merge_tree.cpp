#include "markerless_mocap/segmentation/merge_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace markerless_mocap {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

/// Components of the nodes added so far, each with the peak it keeps.
class Components {
 public:
  explicit Components(size_t nodes) : parent_(nodes, kNone), peak_(nodes, kNone) {}

  void add(uint32_t node, uint32_t peak) {
    parent_[node] = node;
    peak_[node] = peak;
  }
  bool has(uint32_t node) const { return parent_[node] != kNone; }
  uint32_t root(uint32_t node) {
    while (parent_[node] != node) {
      parent_[node] = parent_[parent_[node]];
      node = parent_[node];
    }
    return node;
  }
  uint32_t peak(uint32_t root) const { return peak_[root]; }
  void join(uint32_t root, uint32_t other, uint32_t peak) {
    parent_[other] = root;
    peak_[root] = peak;
  }

 private:
  std::vector<uint32_t> parent_;
  std::vector<uint32_t> peak_;
};

/// Calls onMerge(peak, other_peak, height) -> peak to keep, wherever two components meet. A node
/// is given its component's first peak by peakOf(node).
template <class PeakOf, class OnMerge>
void sweep(const WeightedGraph& graph, const Elevation& elevation, const PeakOf& peakOf,
           const OnMerge& onMerge) {
  Components components(elevation.height.size());
  for (const uint32_t node : elevation.descending) {
    components.add(node, peakOf(node));
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      if (!components.has(graph.neighbor[e])) continue;
      const uint32_t here = components.root(node);
      const uint32_t there = components.root(graph.neighbor[e]);
      if (here == there) continue;
      const uint32_t kept =
          onMerge(components.peak(there), components.peak(here), elevation.height[node]);
      components.join(there, here, kept);
    }
  }
}

/// For each tip the height at which its component first meets another tip's; 0 if never.
std::vector<double> saddles(const WeightedGraph& graph, const Elevation& elevation,
                            const std::vector<uint32_t>& tips) {
  std::vector<double> saddle(tips.size(), 0.0);
  const auto meet = [&](uint32_t tip, double level) { saddle[tip] = std::max(saddle[tip], level); };
  const auto number = [&](uint32_t node) {
    const auto found = std::find(tips.begin(), tips.end(), node);
    return found == tips.end() ? kNone : uint32_t(found - tips.begin());
  };
  sweep(graph, elevation, number, [&](uint32_t a, uint32_t b, double level) {
    if (a == kNone) return b;
    if (b != kNone) {
      meet(a, level);
      meet(b, level);
    }
    return a;
  });
  return saddle;
}

Branch componentAbove(const WeightedGraph& graph, const std::vector<double>& height, uint32_t tip,
                      double level) {
  Branch branch{tip, {tip}};
  std::vector<char> taken(height.size(), 0);
  taken[tip] = 1;
  for (size_t next = 0; next < branch.nodes.size(); ++next) {
    const uint32_t node = branch.nodes[next];
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      const uint32_t neighbor = graph.neighbor[e];
      if (taken[neighbor] || height[neighbor] <= level) continue;
      taken[neighbor] = 1;
      branch.nodes.push_back(neighbor);
    }
  }
  std::sort(branch.nodes.begin(), branch.nodes.end());
  return branch;
}

/// Branch of the highest neighbour above `node` that has one, or -1.
int uphillOwner(const WeightedGraph& graph, const std::vector<double>& height,
                const std::vector<int>& owner, uint32_t node) {
  int found = -1;
  double highest = -1.0;
  for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
    const uint32_t neighbor = graph.neighbor[e];
    if (owner[neighbor] < 0 || height[neighbor] <= highest) continue;
    highest = height[neighbor];
    found = owner[neighbor];
  }
  return found;
}

}  // namespace

Elevation::Elevation(std::vector<double> heights) : height(std::move(heights)) {
  struct Place {
    double height;
    uint32_t node;
  };
  std::vector<Place> places;
  places.reserve(height.size());
  for (uint32_t node = 0; node < height.size(); ++node) places.push_back({height[node], node});
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.height != b.height ? a.height > b.height : a.node < b.node;
  });
  descending.reserve(places.size());
  for (const Place& place : places) descending.push_back(place.node);
}

std::vector<double> distanceFromCore(const Eigenmap& map, const std::vector<uint32_t>& core) {
  if (map.values.size() == 0) return std::vector<double>(size_t(map.vectors.rows()), 0.0);
  const Eigen::VectorXd scale = (map.values[0] / map.values.array()).sqrt();
  Eigen::RowVectorXd origin = Eigen::RowVectorXd::Zero(map.values.size());
  for (const uint32_t node : core) origin += map.vectors.row(node);
  origin /= double(core.size());
  Eigen::ArrayXd square = Eigen::ArrayXd::Zero(map.vectors.rows());
  for (Eigen::Index mode = 0; mode < scale.size(); ++mode) {
    square += ((map.vectors.col(mode).array() - origin[mode]) * scale[mode]).square();
  }
  const Eigen::ArrayXd distance = square.sqrt();
  return {distance.data(), distance.data() + distance.size()};
}

std::vector<uint32_t> persistentMaxima(const WeightedGraph& graph, const Elevation& elevation,
                                       int count) {
  const std::vector<double>& height = elevation.height;
  std::vector<std::pair<double, uint32_t>> ended;  // persistence, peak
  const auto higher = [&](uint32_t a, uint32_t b) {
    return height[a] != height[b] ? height[a] > height[b] : a < b;
  };
  sweep(
      graph, elevation, [](uint32_t node) { return node; },
      [&](uint32_t a, uint32_t b, double level) {
        const uint32_t lower = higher(a, b) ? b : a;
        if (height[lower] > level) ended.emplace_back(height[lower] - level, lower);
        return lower == a ? b : a;
      });
  if (!height.empty()) {
    ended.emplace_back(height[elevation.descending.front()], elevation.descending.front());
  }
  std::sort(ended.begin(), ended.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::vector<uint32_t> peaks;
  for (size_t i = 0; i < ended.size() && i < size_t(count); ++i) peaks.push_back(ended[i].second);
  return peaks;
}

std::vector<Branch> branchesAtTips(const WeightedGraph& graph, const Elevation& elevation,
                                   const std::vector<uint32_t>& tips, double lowest_share) {
  const std::vector<double>& height = elevation.height;
  const std::vector<double> saddle = saddles(graph, elevation, tips);
  std::vector<Branch> branches;
  for (size_t i = 0; i < tips.size(); ++i) {
    const double level = std::max(saddle[i], lowest_share * height[tips[i]]);
    branches.push_back(componentAbove(graph, height, tips[i], level));
  }
  return branches;
}

void growBranches(const WeightedGraph& graph, const Elevation& elevation,
                  const std::vector<int>& growing, double lowest_share,
                  std::vector<Branch>* branches) {
  const std::vector<double>& height = elevation.height;
  std::vector<int> owner(height.size(), -1);
  std::vector<double> level(branches->size(), std::numeric_limits<double>::infinity());
  for (size_t b = 0; b < branches->size(); ++b) {
    for (const uint32_t node : (*branches)[b].nodes) owner[node] = int(b);
  }
  for (const int b : growing) level[b] = lowest_share * height[(*branches)[b].tip];
  const double lowest = level.empty() ? 0.0 : *std::min_element(level.begin(), level.end());
  for (const uint32_t node : elevation.descending) {
    if (height[node] <= lowest) break;
    if (owner[node] >= 0) continue;
    const int uphill = uphillOwner(graph, height, owner, node);
    if (uphill < 0 || height[node] <= level[uphill]) continue;
    owner[node] = uphill;
    (*branches)[uphill].nodes.push_back(node);
  }
  for (Branch& branch : *branches) std::sort(branch.nodes.begin(), branch.nodes.end());
}

}  // namespace markerless_mocap
