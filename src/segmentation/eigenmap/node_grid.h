#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Finds nodes by their cell: a dense box around a set of cells, with an empty border.
class NodeGrid {
 public:
  /// \param cells distinct lattice coordinates (i, j, k), ascending by k, then j, then i; cell n is
  ///   node n. Throws std::invalid_argument if they are not ascending.
  explicit NodeGrid(const std::vector<Eigen::Vector3i>& cells);

  size_t nodeCount() const { return place_of_.size(); }

  /// Node at a step of -1, 0 or 1 along each axis from `node`, or -1.
  int32_t neighbor(uint32_t node, int di, int dj, int dk) const {
    return node_at_[place_of_[node] + offset(di, dj, dk)];
  }

  /// Geodesic distance of each node from the nearest source, in voxels: the length of the shortest
  /// path inside the set over 26-neighbours with 3-4-5 chamfer steps (within 10 % of the Euclidean
  /// length of a straight line). Infinity if there is no path.
  std::vector<double> geodesics(const std::vector<uint32_t>& sources) const;
  /// The same from each source separately.
  std::vector<std::vector<double>> geodesicsOfEach(const std::vector<uint32_t>& sources) const;

  /// A subset of the nodes, empty at first, from which connected components can be taken.
  class Region {
   public:
    explicit Region(const NodeGrid& grid) : grid_(grid), inside_(grid.node_at_.size(), 0) {}

    void put(const std::vector<uint32_t>& nodes) { set(nodes, 1); }
    void remove(const std::vector<uint32_t>& nodes) { set(nodes, 0); }
    bool has(uint32_t node) const { return inside_[grid_.place_of_[node]] != 0; }
    /// Removes and returns the nodes of the region that are connected with `start` over
    /// 26-neighbours, the nearest first; stops as soon as `wanted` is among them.
    std::vector<uint32_t> takeConnected(uint32_t start, uint32_t wanted);

   private:
    void set(const std::vector<uint32_t>& nodes, uint8_t value) {
      for (const uint32_t node : nodes) inside_[grid_.place_of_[node]] = value;
    }

    const NodeGrid& grid_;
    std::vector<uint8_t> inside_;  // per cell of the box
  };

 private:
  /// Computes path costs by sweeps in forward and backward order, repeated until no cost decreases:
  /// a sequential chamfer distance (Rosenfeld and Pfaltz 1966), repeated for paths that turn.
  /// \param sources not empty
  /// \param costs costs[1 + node] is the cost of the node, in thirds of a voxel, 0 at sources;
  ///   costs[0] stands for all cells outside the set and stays unreached
  template <class Costs>
  void sweep(const std::vector<uint32_t>& sources, std::vector<Costs>* costs) const;
  int64_t offset(int di, int dj, int dk) const {
    return di + int64_t(size_[0]) * (dj + int64_t(size_[1]) * dk);
  }

  std::array<int, 3> size_{};
  std::vector<int32_t> node_at_;   ///< node of each cell of the box, or -1
  std::vector<int64_t> place_of_;  ///< cell of each node in the box
};

}  // namespace markerless_mocap
