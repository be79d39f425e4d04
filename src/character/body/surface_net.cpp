#include "character/body/surface_net.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;
using Field = std::function<double(const Vector3d&)>;

constexpr int kBlock = 4;

/// Signed distances at the half of a lattice with y >= 0; the other half is its mirror image.
class HalfLattice {
 public:
  HalfLattice(const Field& field, const Eigen::AlignedBox3d& box, double pitch)
      : origin_(box.min().x(), 0.0, box.min().z()), pitch_(pitch) {
    const Vector3d extent(box.sizes().x(), box.max().y(), box.sizes().z());
    for (int a = 0; a < 3; ++a) {
      const int blocks = int(std::ceil(extent[a] / (pitch * kBlock)));
      size_[a] = blocks * kBlock + 1;
    }
    values_.assign(size_t(size_.x()) * size_t(size_.y()) * size_t(size_.z()), 1.0f);
    tbb::parallel_for(0, (size_.z() + kBlock - 1) / kBlock, [&](int k) { fillSlab(field, k); });
    while (partDiagonals()) {
    }
  }

  const Vector3i& size() const { return size_; }
  Vector3d place(const Vector3i& i) const { return origin_ + pitch_ * i.cast<double>(); }
  float at(const Vector3i& i) const { return values_[index(i)]; }

 private:
  size_t index(const Vector3i& i) const {
    return (size_t(i.z()) * size_t(size_.y()) + size_t(std::abs(i.y()))) * size_t(size_.x()) +
           size_t(i.x());
  }

  /// In blocks far from the surface all values are set to that of the centre.
  void fillSlab(const Field& field, int block_z) {
    Vector3i corner(0, 0, block_z * kBlock);
    for (; corner.y() < size_.y(); corner.y() += kBlock)
      for (corner.x() = 0; corner.x() < size_.x(); corner.x() += kBlock) {
        const double centre =
            field(place(corner) + Vector3d::Constant(pitch_ * (kBlock - 1) / 2.0));
        const bool far = std::abs(centre) > 1.6 * std::sqrt(3.0) / 2.0 * kBlock * pitch_;
        const Vector3i end = (corner + Vector3i::Constant(kBlock)).cwiseMin(size_);
        for (Vector3i i = corner; i.z() < end.z(); ++i.z())
          for (i.y() = corner.y(); i.y() < end.y(); ++i.y())
            for (i.x() = corner.x(); i.x() < end.x(); ++i.x())
              values_[index(i)] = float(far ? centre : field(place(i)));
      }
  }

  /// If the inner corners of a square are connected by its diagonal only, one of them is set to
  /// outer, so that no edge of the surface belongs to four quads. Returns whether there was such a
  /// square.
  bool partDiagonals() {
    bool any = false;
    Vector3i i;
    for (i.z() = 0; i.z() < size_.z(); ++i.z())
      for (i.y() = 0; i.y() < size_.y(); ++i.y())
        for (i.x() = 0; i.x() < size_.x(); ++i.x())
          for (int a = 0; a < 3; ++a) any |= partDiagonal(i, (a + 1) % 3, (a + 2) % 3);
    return any;
  }

  bool partDiagonal(const Vector3i& i, int a, int b) {
    if (i[a] + 1 >= size_[a] || i[b] + 1 >= size_[b]) return false;
    const Vector3i da = Vector3i::Unit(a), db = Vector3i::Unit(b);
    float* corners[4] = {&values_[index(i)], &values_[index(i + da)], &values_[index(i + da + db)],
                         &values_[index(i + db)]};
    const bool inner = *corners[0] < 0;
    if ((*corners[1] < 0) == inner || (*corners[2] < 0) != inner || (*corners[3] < 0) == inner)
      return false;
    float* one = corners[inner ? 0 : 1];
    float* other = corners[inner ? 2 : 3];
    (*one > *other ? *one : *other) = float(0.01 * pitch_);
    return true;
  }

  Vector3d origin_;
  double pitch_;
  Vector3i size_;
  std::vector<float> values_;
};

/// Mean of the points at which the surface crosses the edges of a cell.
bool cellVertex(const HalfLattice& lattice, const Vector3i& cell, Vector3d& vertex) {
  Vector3d sum = Vector3d::Zero();
  int crossings = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3i from = cell + Vector3i(corner & 1, corner >> 1 & 1, corner >> 2);
    for (int a = 0; a < 3; ++a) {
      if (corner >> a & 1) continue;
      const Vector3i to = from + Vector3i::Unit(a);
      const float d0 = lattice.at(from), d1 = lattice.at(to);
      if ((d0 < 0) == (d1 < 0)) continue;
      sum +=
          lattice.place(from) + double(d0 / (d0 - d1)) * (lattice.place(to) - lattice.place(from));
      ++crossings;
    }
  }
  if (crossings == 0) return false;
  vertex = sum / crossings;
  return true;
}

class Net {
 public:
  explicit Net(const HalfLattice& lattice)
      : lattice_(lattice),
        lowest_(0, 1 - lattice.size().y(), 0),
        cells_(lattice.size() - Vector3i::Ones() - lowest_),
        vertex_of_(size_t(cells_.x()) * size_t(cells_.y()) * size_t(cells_.z()), -1) {}

  Surface build() {
    forEachCell([&](const Vector3i& cell) {
      Vector3d vertex;
      if (!cellVertex(lattice_, cell, vertex)) return;
      vertex_of_[index(cell)] = int(surface_.vertices.size());
      surface_.vertices.push_back(vertex);
    });
    forEachCell([&](const Vector3i& cell) {
      for (int a = 0; a < 3; ++a) addQuad(cell, a);
    });
    return std::move(surface_);
  }

 private:
  size_t index(const Vector3i& cell) const {
    const Vector3i c = cell - lowest_;
    return (size_t(c.z()) * size_t(cells_.y()) + size_t(c.y())) * size_t(cells_.x()) +
           size_t(c.x());
  }

  template <class Visit>
  void forEachCell(const Visit& visit) const {
    const Vector3i end = lowest_ + cells_;
    Vector3i cell;
    for (cell.z() = lowest_.z(); cell.z() < end.z(); ++cell.z())
      for (cell.y() = lowest_.y(); cell.y() < end.y(); ++cell.y())
        for (cell.x() = lowest_.x(); cell.x() < end.x(); ++cell.x()) visit(cell);
  }

  /// Adds the quad around the lattice edge from `cell`'s corner along axis `a`, if the surface cuts
  /// it.
  void addQuad(const Vector3i& cell, int a) {
    const bool inner = lattice_.at(cell) < 0,
               next_inner = lattice_.at(cell + Vector3i::Unit(a)) < 0;
    if (inner == next_inner) return;
    const Vector3i b = Vector3i::Unit((a + 1) % 3), c = Vector3i::Unit((a + 2) % 3);
    std::array<int, 4> quad{vertex_of_[index(cell - b - c)], vertex_of_[index(cell - c)],
                            vertex_of_[index(cell)], vertex_of_[index(cell - b)]};
    if (!inner) std::swap(quad[1], quad[3]);
    surface_.quads.push_back(quad);
  }

  const HalfLattice& lattice_;
  Vector3i lowest_, cells_;
  std::vector<int> vertex_of_;
  Surface surface_;
};

/// Moves each vertex halfway to the mean of its neighbours.
void smoothVertices(Surface& surface) {
  std::vector<Vector3d> sums(surface.vertices.size(), Vector3d::Zero());
  std::vector<int> counts(surface.vertices.size(), 0);
  for (const std::array<int, 4>& quad : surface.quads)
    for (size_t i = 0; i < 4; ++i) {
      sums[size_t(quad[i])] += surface.vertices[size_t(quad[(i + 1) % 4])];
      ++counts[size_t(quad[i])];
    }
  for (size_t v = 0; v < sums.size(); ++v)
    surface.vertices[v] = 0.5 * (surface.vertices[v] + sums[v] / counts[v]);
}

/// Projects a point onto the surface by Newton steps along the gradient, up to a distance of
/// `reach`.
Vector3d ontoSurface(const Field& field, Vector3d p, double reach) {
  const Vector3d start = p;
  const double step = 0.001;
  for (int n = 0; n < 3; ++n) {
    const double d = field(p);
    if (std::abs(d) < 1e-5) break;
    Vector3d slope;
    for (int a = 0; a < 3; ++a) {
      const Vector3d h = step * Vector3d::Unit(a);
      slope[a] = (field(p + h) - field(p - h)) / (2.0 * step);
    }
    p -= d * slope / std::max(slope.squaredNorm(), 0.1);
  }
  const Vector3d move = p - start;
  return move.norm() > reach ? Vector3d(start + move * (reach / move.norm())) : p;
}

}  // namespace

Surface surfaceOf(const Field& field, const Eigen::AlignedBox3d& box, double pitch) {
  Surface surface = Net(HalfLattice(field, box, pitch)).build();
  for (int round = 0; round < 2; ++round) {
    smoothVertices(surface);
    tbb::parallel_for(size_t(0), surface.vertices.size(), [&](size_t v) {
      surface.vertices[v] = ontoSurface(field, surface.vertices[v], pitch);
    });
  }
  return surface;
}

}  // namespace markerless_mocap
