#include "capture/shadow_map.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr float kTexel = 0.02f;       // metres on the floor
constexpr float kFarthest = 12.0f;    // metres from the lamp's foot; no shadow is followed further
constexpr float kLeastBelow = 0.3f;   // metres under the lamp; what is higher casts no shadow
constexpr int kSearch = 12;           // texels about a place where its occluders are looked for
constexpr int kBorder = 2 * kSearch;  // texels
constexpr float kSlack = 1e-3f;       // of a triangle, so that neighbours leave no gap
constexpr float kLeastDistance = 0.05f;  // metres; what is nearer does not shade a vertex

}  // namespace

/// Sums over squares of texels.
class ShadowMap::SumTable {
 public:
  SumTable(const std::vector<float>& values, cv::Size size)
      : size_(size), sums_(size_t(size.width + 1) * (size.height + 1), 0.0) {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        at(x + 1, y + 1) =
            values[size_t(y) * size.width + x] + at(x, y + 1) + at(x + 1, y) - at(x, y);
  }

  /// Sum over the square of the given reach; what lies outside is zero.
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
  const float below = std::max(lamp.position.z() - place.z(), kLeastBelow);
  const Eigen::Vector2f aside = place.head<2>() - lamp.position.head<2>();
  return aside * (lamp.position.z() / below / kTexel);
}

ShadowMap::ShadowMap(const Lamp& lamp, const std::vector<SceneObject>& objects) : lamp_(lamp) {
  findRect(objects);
  if (empty()) return;
  nearness_.assign(size_t(rect_.area()), 0.0f);
  for (const SceneObject& object : objects) draw(object);
  soften();
}

void ShadowMap::findRect(const std::vector<SceneObject>& objects) {
  constexpr float kMost = kFarthest / kTexel;
  Eigen::Vector2f low(kMost, kMost), high(-kMost, -kMost);
  for (const SceneObject& object : objects)
    for (const Eigen::Vector3f& vertex : object.vertices) {
      if (lamp_.position.z() - vertex.z() < kLeastBelow) continue;
      const Eigen::Vector2f texel = shadowTexel(lamp_, vertex) - Eigen::Vector2f(rect_.x, rect_.y);
      if (!(texel.x() >= 1.0f && texel.y() >= 1.0f && texel.x() < float(rect_.width - 2) &&
            texel.y() < float(rect_.height - 2)))
        return 0.0f;
      const int x = int(texel.x() + 0.5f), y = int(texel.y() + 0.5f);
      int hidden = 0;
      for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u)
          hidden += nearness_[size_t(v) * rect_.width + u] > least_nearness;
      return float(hidden) / 9.0f;
    }

}  // namespace markerless_mocap
