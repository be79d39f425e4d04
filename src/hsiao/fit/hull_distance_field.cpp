#include "hsiao/fit/hull_distance_field.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// Empty cells around the hull, so that the field has a gradient outside.
constexpr int kBorder = 8;
constexpr float kFar = 1e10f;
constexpr double kMaxCells = 200e6;  // 13 bytes each while the field is made

// One line of the transform: lower envelope of the parabolas with vertices at f.
void transformLine(const std::vector<float>& f, int n, std::vector<float>& out) {
  thread_local std::vector<int> root;
  thread_local std::vector<float> border;
  root.assign(n, 0);
  border.assign(n + 1, kFar);
  int k = 0;
  border[0] = -kFar;
  const auto crossing = [&f](int p, int q) {
    return ((f[q] + float(q) * q) - (f[p] + float(p) * p)) / float(2 * (q - p));
  };
  for (int q = 1; q < n; ++q) {
    float s = crossing(root[k], q);
    while (k > 0 && s <= border[k]) s = crossing(root[--k], q);
    root[++k] = q;
    border[k] = s;
    border[k + 1] = kFar;
  }
  k = 0;
  for (int q = 0; q < n; ++q) {
    while (border[k + 1] < float(q)) ++k;
    const float way = float(q - root[k]);
    out[q] = way * way + f[root[k]];
  }
}

}  // namespace

void squaredDistanceTransform(std::vector<float>& values, const Vector3i& size) {
  const size_t stride[3] = {1, size_t(size.x()), size_t(size.x()) * size.y()};
  for (int axis = 0; axis < 3; ++axis) {
    const int n = size[axis], u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<float> line(n), out(n);
    for (int i = 0; i < size[u]; ++i)
      for (int j = 0; j < size[v]; ++j) {
        float* first = values.data() + i * stride[u] + j * stride[v];
        for (int k = 0; k < n; ++k) line[k] = first[k * stride[axis]];
        transformLine(line, n, out);
        for (int k = 0; k < n; ++k) first[k * stride[axis]] = out[k];
      }
  }
}

HullDistanceField::HullDistanceField(const VisualHull& hull) : pitch_(hull.lattice.pitch) {
  crop(hull);
  std::vector<uint8_t> filled(size_t(size_.prod()), 0);
  for (const HullVoxel& voxel : hull.voxels)
    filled[cell(hull.lattice.coordinates(voxel.index) - corner_)] = 1;
  findSurface(hull, filled);
  std::vector<float> outside(filled.size()), inside(filled.size());
  for (size_t i = 0; i < filled.size(); ++i) {
    outside[i] = filled[i] ? 0.0f : kFar;
    inside[i] = filled[i] ? kFar : 0.0f;
  }
  squaredDistanceTransform(outside, size_);
  squaredDistanceTransform(inside, size_);
  // The surface is half a voxel away from the voxel centres on both sides.
  distance_.resize(filled.size());
  for (size_t i = 0; i < filled.size(); ++i)
    distance_[i] =
        float(pitch_) * (filled[i] ? 0.5f - std::sqrt(inside[i]) : std::sqrt(outside[i]) - 0.5f);
}

void HullDistanceField::crop(const VisualHull& hull) {
  if (hull.voxels.empty()) throw std::invalid_argument("a hull without voxels has no distances");
  Vector3i low = hull.lattice.coordinates(hull.voxels.front().index), high = low;
  for (const HullVoxel& voxel : hull.voxels) {
    low = low.cwiseMin(hull.lattice.coordinates(voxel.index));
    high = high.cwiseMax(hull.lattice.coordinates(voxel.index));
  }
  corner_ = low.array() - kBorder;
  size_ = high - corner_ + Vector3i::Constant(kBorder + 1);
  const double cells = size_.cast<double>().prod();
  if (!(cells <= kMaxCells))
    throw std::invalid_argument("the hull lies in a box of " +
                                std::to_string(std::llround(cells / 1e6)) +
                                " million voxels, allowed are 200 million");
  first_center_ = hull.lattice.origin + pitch_ * (corner_.cast<double>().array() + 0.5).matrix();
}

void HullDistanceField::findSurface(const VisualHull& hull, const std::vector<uint8_t>& filled) {
  const long row = size_.x(), slice = row * size_.y();
  for (uint32_t i = 0; i < hull.voxels.size(); ++i) {
    const uint8_t* here = &filled[cell(hull.lattice.coordinates(hull.voxels[i].index) - corner_)];
    if (!(here[1] && here[-1] && here[row] && here[-row] && here[slice] && here[-slice]))
      surface_.push_back(i);
  }
}

double HullDistanceField::signedDistance(const Vector3d& point) const {
  const Vector3d at = (point - first_center_) / pitch_;
  if (at.hasNaN()) return at.sum();  // no cell
  const Vector3d inside =
      at.cwiseMax(0.0).cwiseMin(size_.cast<double>().array().matrix() - Vector3d::Constant(1.001));
  const Vector3i c = inside.cast<int>();
  const Vector3d t = inside - c.cast<double>();
  const float* d = &distance_[cell(c)];
  const size_t row = size_.x(), slice = row * size_.y();
  const auto alongX = [&](size_t offset) {
    return d[offset] + t.x() * (double(d[offset + 1]) - d[offset]);
  };
  const double low = alongX(0) + t.y() * (alongX(row) - alongX(0));
  const double high = alongX(slice) + t.y() * (alongX(slice + row) - alongX(slice));
  return low + t.z() * (high - low) + pitch_ * (at - inside).norm();
}

}  // namespace markerless_mocap
