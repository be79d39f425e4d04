#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Finds voxels by their place: a dense box around a set of cells, with an empty border.
class NodeGrid {
 public:
  /// \param cells distinct lattice coordinates (i, j, k), ascending by k, then j, then i; cell n
  ///        becomes node n. Throws std::invalid_argument where they do not ascend.
  explicit NodeGrid(const std::vector<Eigen::Vector3i>& cells);

  size_t nodeCount() const { return place_of_.size(); }

  /// Node at a step of -1, 0 or 1 along each axis from `node`, or -1.
  int32_t neighbor(uint32_t node, int di, int dj, int dk) const {
    return node_at_[place_of_[node] + offset(di, dj, dk)];
  }

  /// Length of the shortest way inside the set from each node to the nearest source, over 26
  /// neighbours with the 3-4-5 chamfer steps (within 10 % of the Euclidean length of a straight
  /// way), in voxels. Infinity where no way leads.
  std::vector<double> geodesics(const std::vector<uint32_t>& sources) const;
  /// The same from each source by itself.
  std::vector<std::vector<double>> geodesicsOfEach(const std::vector<uint32_t>& sources) const;

  /// Some of the nodes, to be taken out by what is connected; none at first.
  class Region {
   public:
    explicit Region(const NodeGrid& grid) : grid_(grid), inside_(grid.node_at_.size(), 0) {}

    void put(const std::vector<uint32_t>& nodes) { set(nodes, 1); }
    void takeOut(const std::vector<uint32_t>& nodes) { set(nodes, 0); }
    bool has(uint32_t node) const { return inside_[grid_.place_of_[node]] != 0; }
    /// Takes out and returns the nodes that are connected with one over 26 neighbours in the
    /// region, the nearest first; no more once `wanted` is among them.
    std::vector<uint32_t> takeConnected(uint32_t start, uint32_t wanted);

   private:
    void set(const std::vector<uint32_t>& nodes, uint8_t value) {
      for (const uint32_t node : nodes) inside_[grid_.place_of_[node]] = value;
    }

    const NodeGrid& grid_;
    std::vector<uint8_t> inside_;  // of each place of the box
  };

 private:
  /// Relaxes costs of ways along the lattice and against it in turn until none falls any more: a
  /// sequential chamfer distance (Rosenfeld and Pfaltz 1966), repeated for ways that turn.
  /// \param sources not empty
  /// \param costs at 1 + node those of the node, three to the voxel, 0 at sources; the first stands
  ///        for all places outside the set and is never reached
  template <class Costs>
  void sweep(const std::vector<uint32_t>& sources, std::vector<Costs>* costs) const;
  int64_t offset(int di, int dj, int dk) const {
    return di + int64_t(size_[0]) * (dj + int64_t(size_[1]) * dk);
  }

  std::array<int, 3> size_{};
  std::vector<int32_t> node_at_;   ///< node of each place of the box, or -1
  std::vector<int64_t> place_of_;  ///< place of each node in the box
};

}  // namespace markerless_mocap
