#include "capture/scene/shadow_map.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr float kTexel = 0.02f;  // metres on the floor
/// Metres from the point under the lamp; shadows further away are not computed.
constexpr float kMaxDistance = 12.0f;
constexpr float kMinBelow = 0.3f;     // metres below the lamp; objects above this cast no shadow
constexpr int kSearch = 12;           // reach of the search for occluders, texels
constexpr int kBorder = 2 * kSearch;  // texels
/// Tolerance of a triangle, so that there are no gaps between neighbours.
constexpr float kSlack = 1e-3f;
constexpr float kMinDistance = 0.05f;  // metres; nearer objects do not shade a vertex

}  // namespace

/// Sums over squares of texels.
class ShadowMap::SummedAreaTable {
 public:
  SummedAreaTable(const std::vector<float>& values, cv::Size size)
      : size_(size), sums_(size_t(size.width + 1) * (size.height + 1), 0.0) {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        at(x + 1, y + 1) =
            values[size_t(y) * size.width + x] + at(x, y + 1) + at(x + 1, y) - at(x, y);
  }

  /// Sum over a square of the given reach; values outside the map are 0.
  double square(int x, int y, int reach) const {
    const int x0 = std::max(x - reach, 0), x1 = std::min(x + reach + 1, size_.width);
    const int y0 = std::max(y - reach, 0), y1 = std::min(y + reach + 1, size_.height);
    return at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0);
  }

 private:
  double& at(int x, int y) { return sums_[size_t(y) * (size_.width + 1) + x]; }
  double at(int x, int y) const { return sums_[size_t(y) * (size_.width + 1) + x]; }

  cv::Size size_;
  std::vector<double> sums_;
};

Eigen::Vector2f shadowTexel(const Lamp& lamp, const Eigen::Vector3f& place) {
  const float below = std::max(lamp.position.z() - place.z(), kMinBelow);
  const Eigen::Vector2f aside = place.head<2>() - lamp.position.head<2>();
  return aside * (lamp.position.z() / below / kTexel);
}

ShadowMap::ShadowMap(const Lamp& lamp, const std::vector<SceneObject>& objects) : lamp_(lamp) {
  findRect(objects);
  if (empty()) return;
  inverse_depth_.assign(size_t(rect_.area()), 0.0f);
  for (const SceneObject& object : objects)
    if (!object.shines) draw(object);
  soften();
}

void ShadowMap::findRect(const std::vector<SceneObject>& objects) {
  constexpr float kMaxTexel = kMaxDistance / kTexel;
  Eigen::Vector2f low(kMaxTexel, kMaxTexel), high(-kMaxTexel, -kMaxTexel);
  for (const SceneObject& object : objects)
    for (const Eigen::Vector3f& vertex : object.vertices) {
      if (object.shines) break;
      if (lamp_.position.z() - vertex.z() < kMinBelow) continue;
      const Eigen::Vector2f texel = shadowTexel(lamp_, vertex);
      low = low.cwiseMin(texel);
      high = high.cwiseMax(texel);
    }
  low = low.cwiseMax(-kMaxTexel);
  high = high.cwiseMin(kMaxTexel);
  if (low.x() > high.x() || low.y() > high.y()) return;
  const cv::Point from(int(std::floor(low.x())) - kBorder, int(std::floor(low.y())) - kBorder);
  const cv::Point to(int(std::ceil(high.x())) + kBorder + 1,
                     int(std::ceil(high.y())) + kBorder + 1);
  rect_ = cv::Rect(from, to);
}

void ShadowMap::draw(const SceneObject& object) {
  std::vector<Eigen::Vector3f> shadows(object.vertices.size());  // texel and inverse depth
  for (size_t i = 0; i < shadows.size(); ++i) {
    const float below = lamp_.position.z() - object.vertices[i].z();
    shadows[i] << shadowTexel(lamp_, object.vertices[i]), below < kMinBelow ? 0.0f : 1.0f / below;
  }
  for (const auto& [a, b, c] : object.mesh->triangles) {
    const Eigen::Vector3f corners[3] = {shadows[a], shadows[b], shadows[c]};
    if (corners[0].z() > 0.0f && corners[1].z() > 0.0f && corners[2].z() > 0.0f)
      drawTriangle(corners);
  }
}

void ShadowMap::drawTriangle(const Eigen::Vector3f (&corners)[3]) {
  const Eigen::Array3f x(corners[0].x(), corners[1].x(), corners[2].x());
  const Eigen::Array3f y(corners[0].y(), corners[1].y(), corners[2].y());
  const int x0 = int(std::max(std::ceil(x.minCoeff()), float(rect_.x)));
  const int x1 = int(std::min(std::floor(x.maxCoeff()), float(rect_.br().x - 1)));
  const int y0 = int(std::max(std::ceil(y.minCoeff()), float(rect_.y)));
  const int y1 = int(std::min(std::floor(y.maxCoeff()), float(rect_.br().y - 1)));
  const float area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (x0 > x1 || y0 > y1 || area == 0.0f) return;
  for (int v = y0; v <= y1; ++v)
    for (int u = x0; u <= x1; ++u) {
      const float b = ((u - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (v - y[0])) / area;
      const float c = ((x[1] - x[0]) * (v - y[0]) - (u - x[0]) * (y[1] - y[0])) / area;
      if (b < -kSlack || c < -kSlack || b + c > 1.0f + kSlack) continue;
      const float inverse_depth = corners[0].z() + b * (corners[1].z() - corners[0].z()) +
                                  c * (corners[2].z() - corners[0].z());
      float& texel = inverse_depth_[size_t(v - rect_.y) * rect_.width + (u - rect_.x)];
      texel = std::max(texel, inverse_depth);
    }
}

int ShadowMap::penumbra(const SummedAreaTable& cover, const SummedAreaTable& near, int x,
                        int y) const {
  int reach = kSearch;
  // Repeating the search within the radius found keeps the shadow of a foot sharp below that of a
  // knee.
  for (int i = 0; i < 3; ++i) {
    const double occluders = cover.square(x, y, reach);
    if (occluders < 0.5) return i == 0 ? 0 : reach;
    const double inverse_depth = near.square(x, y, reach) / occluders;
    // Similar triangles at the occluder.
    const double radius = lamp_.radius * (lamp_.position.z() * inverse_depth - 1.0) / kTexel;
    reach = std::clamp(int(std::lround(radius)), 1, reach);
  }
  return reach;
}

void ShadowMap::soften() {
  std::vector<float> covered(inverse_depth_.size());
  for (size_t i = 0; i < covered.size(); ++i) covered[i] = inverse_depth_[i] > 0.0f;
  const SummedAreaTable cover(covered, rect_.size()), near(inverse_depth_, rect_.size());
  occlusion_.assign(inverse_depth_.size(), 0.0f);
  for (int y = 0; y < rect_.height; ++y)
    for (int x = 0; x < rect_.width; ++x) {
      const int reach = penumbra(cover, near, x, y);
      if (reach == 0) continue;
      occlusion_[size_t(y) * rect_.width + x] =
          float(cover.square(x, y, reach) / ((2 * reach + 1) * (2 * reach + 1)));
    }
}

float ShadowMap::occlusion(const Eigen::Vector2f& texel) const {
  const float x = texel.x() - rect_.x, y = texel.y() - rect_.y;
  if (!(x >= 0.0f && y >= 0.0f && x < rect_.width - 1 && y < rect_.height - 1)) return 0.0f;
  const int column = int(x), row = int(y);
  const float u = x - column, v = y - row;
  const float* const upper = &occlusion_[size_t(row) * rect_.width + column];
  const float* const lower = upper + rect_.width;
  return (1 - v) * ((1 - u) * upper[0] + u * upper[1]) + v * ((1 - u) * lower[0] + u * lower[1]);
}

float ShadowMap::occludedFraction(const Eigen::Vector3f& vertex) const {
  const float below = lamp_.position.z() - vertex.z();
  if (empty() || below < kMinBelow) return 0.0f;
  const float min_inverse_depth = 1.0f / std::max(below - kMinDistance, 0.1f);
  const Eigen::Vector2f texel = shadowTexel(lamp_, vertex) - Eigen::Vector2f(rect_.x, rect_.y);
  if (!(texel.x() >= 1.0f && texel.y() >= 1.0f && texel.x() < float(rect_.width - 2) &&
        texel.y() < float(rect_.height - 2)))
    return 0.0f;
  const int x = int(texel.x() + 0.5f), y = int(texel.y() + 0.5f);
  int hidden = 0;
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      hidden += inverse_depth_[size_t(v) * rect_.width + u] > min_inverse_depth;
  return float(hidden) / 9.0f;
}

}  // namespace markerless_mocap
