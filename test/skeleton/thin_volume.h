#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

/// A small volume that is counted in the plainest way.
class ThinVolume {
 public:
  ThinVolume(int nx, int ny, int nz) : filled_(size_t(nx) * size_t(ny) * size_t(nz), 0) {
    lattice.size = {nx, ny, nz};
  }
  ThinVolume(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels)
      : lattice(lattice), filled_(lattice.count(), 0) {
    for (uint32_t index : voxels) filled_[index] = 1;
  }

  bool at(int x, int y, int z) const {
    return inside(x, y, z) && filled_[lattice.index(x, y, z)] != 0;
  }
  void set(int x, int y, int z, bool value = true) {
    if (inside(x, y, z)) filled_[lattice.index(x, y, z)] = value;
  }
  std::vector<uint32_t> voxels() const {
    std::vector<uint32_t> result;
    for (uint32_t i = 0; i < filled_.size(); ++i)
      if (filled_[i] != 0) result.push_back(i);
    return result;
  }
  template <class Where>
  ThinVolume& fillWhere(Where where) {
    for (int z = 0; z < lattice.size.z(); ++z)
      for (int y = 0; y < lattice.size.y(); ++y)
        for (int x = 0; x < lattice.size.x(); ++x)
          if (where(x, y, z)) set(x, y, z);
    return *this;
  }
  /// Neighbours among the 26.
  int neighborCount(int x, int y, int z) const {
    int count = -1;
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) count += at(x + i, y + j, z + k);
    return count;
  }

  /// 26-components of the object.
  int components() const { return flood(true).second; }
  /// 6-components of the background that the outside does not reach.
  int cavities() const { return flood(false).second - 1; }
  /// Corners - edges + faces - cubes of the union of the voxels' closed cubes:
  /// components - tunnels + cavities.
  int euler() const {
    int count = 0;
    const Eigen::Vector3i& n = lattice.size;
    for (int z = 0; z <= n.z(); ++z) {
      for (int y = 0; y <= n.y(); ++y) {
        for (int x = 0; x <= n.x(); ++x) {
          for (int cell = 0; cell < 8; ++cell) {
            const std::array<int, 3> thick = {cell & 1, cell >> 1 & 1, cell >> 2};
            count += (thick[0] + thick[1] + thick[2]) % 2 == 0 ? touched(x, y, z, thick)
                                                               : -touched(x, y, z, thick);
          }
        }
      }
    }
    return count;
  }
  int tunnels() const { return components() + cavities() - euler(); }

  /// All components of the largest size.
  std::vector<ThinVolume> largestComponents() const {
    const auto [number, count] = flood(true);
    std::vector<size_t> size(size_t(count) + 1, 0);
    for (int n : number) ++size[size_t(n)];
    size[0] = 0;
    std::vector<ThinVolume> largest;
    for (int i = 1; i <= count; ++i)
      if (size[size_t(i)] == *std::max_element(size.begin(), size.end()))
        largest.push_back(whereNumber(number, [&](int n) { return n == i; }));
    return largest;
  }
  /// With what the outside does not reach.
  ThinVolume filled() const {
    return whereNumber(flood(false).first, [](int n) { return n != 1; });
  }

  VoxelLattice lattice;

 private:
  bool inside(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < lattice.size.x() && y < lattice.size.y() &&
           z < lattice.size.z();
  }
  /// Whether a voxel has the cell of the grid of corners whose lowest corner is at (x, y, z).
  int touched(int x, int y, int z, const std::array<int, 3>& thick) const {
    for (int k = thick[2] - 1; k <= 0; ++k)
      for (int j = thick[1] - 1; j <= 0; ++j)
        for (int i = thick[0] - 1; i <= 0; ++i)
          if (at(x + i, y + j, z + k)) return 1;
    return 0;
  }
  template <class Where>
  ThinVolume whereNumber(const std::vector<int>& number, Where where) const {
    ThinVolume result(lattice.size.x(), lattice.size.y(), lattice.size.z());
    const int nx = lattice.size.x() + 2, ny = lattice.size.y() + 2;
    return result.fillWhere([&](int x, int y, int z) {
      return where(number[size_t(((z + 1) * ny + y + 1) * nx + x + 1)]);
    });
  }
  /// Component numbers from 1 of a box one voxel larger on all sides, and how many there are.
  std::pair<std::vector<int>, int> flood(bool object) const {
    const Eigen::Vector3i n = lattice.size + Eigen::Vector3i::Constant(2);
    std::vector<int> number(size_t(n.prod()), 0);
    int count = 0;
    const auto place = [&](const Eigen::Vector3i& p) {
      return size_t((p.z() * n.y() + p.y()) * n.x() + p.x());
    };
    const auto wanted = [&](const Eigen::Vector3i& p) {
      return at(p.x() - 1, p.y() - 1, p.z() - 1) == object && number[place(p)] == 0;
    };
    std::vector<Eigen::Vector3i> open;
    for (int i = 0; i < n.prod(); ++i) {
      const Eigen::Vector3i start(i % n.x(), i / n.x() % n.y(), i / (n.x() * n.y()));
      if (!wanted(start)) continue;
      number[place(start)] = ++count;
      open.push_back(start);
      while (!open.empty()) {
        const Eigen::Vector3i p = open.back();
        open.pop_back();
        for (int s = 0; s < 27; ++s) {
          const Eigen::Vector3i step(s % 3 - 1, s / 3 % 3 - 1, s / 9 - 1);
          const Eigen::Vector3i q = p + step;
          if ((!object && step.cwiseAbs().sum() != 1) || q.minCoeff() < 0 ||
              (n - q).minCoeff() < 1 || !wanted(q))
            continue;
          number[place(q)] = count;
          open.push_back(q);
        }
      }
    }
    return {number, count};
  }

  std::vector<uint8_t> filled_;
};

}  // namespace markerless_mocap
