#include "capture/scene/moving_picture.h"

#include <algorithm>
#include <cmath>

#include "capture/scene/value_noise.h"
#include "numerics/split_mix.h"

namespace markerless_mocap {
namespace {

constexpr float kCell = 0.02f;  // metres

/// A colour of its own for each number.
Eigen::Vector3f anyColor(uint64_t number) {
  return {float(splitMixUniform(3 * number)), float(splitMixUniform(3 * number + 1)),
          float(splitMixUniform(3 * number + 2))};
}

}  // namespace

ColoredMesh screenMesh(const Panel& panel, double seconds) {
  constexpr double kShotSeconds = 1.5;
  const auto shot = uint64_t(int64_t(std::floor(seconds / kShotSeconds)));
  const float bright = 0.45f + 0.5f * float(splitMixUniform(splitMix64(shot)));
  const Eigen::Vector3f one = anyColor(2 * shot), other = anyColor(2 * shot + 1);
  // Less than a whole period of the noise, so that floats stay exact however long the film is.
  const float drift = float(std::remainder(0.35 * seconds, 128.0));
  ColoredMesh mesh;
  const auto color = [&](float u, float v) -> Eigen::Vector3f {
    const float mix = 0.5f + 0.5f * smoothNoise(shot, 3.0f * u + drift, 3.0f * v - 0.4f * drift);
    const float detail = 1.0f + 0.3f * smoothNoise(shot + 1, 8.0f * u - 2.0f * drift, 8.0f * v);
    return (bright * detail * (one + mix * (other - one))).cwiseMin(1.0f);
  };
  addPanel(panel, kCell, color, &mesh);
  return mesh;
}

ColoredMesh windowMesh(const Panel& panel, double seconds) {
  constexpr float kFrame = 0.06f;
  const float width = panel.along_u.norm(), height = panel.along_v.norm();
  const float gust = float(0.06 * std::sin(1.9 * seconds) + 0.03 * std::sin(5.1 * seconds + 1.0));
  const float rustle = float(0.02 * std::sin(8.3 * seconds));
  ColoredMesh mesh;
  const auto color = [&](float u, float v) -> Eigen::Vector3f {
    const float to_edge = std::min({u, width - u, v, height - v, std::abs(u - width / 2)});
    if (to_edge < kFrame) return Eigen::Vector3f::Constant(0.72f);
    // Twigs sway further the higher they are.
    const float x = u + gust * v, y = v + rustle * std::sin(9.0f * u);
    const float leaves = fractalNoise(31, x, y, 0.45f, 4) + 0.45f - 0.8f * v / height;
    if (leaves < 0.0f) return Eigen::Vector3f(0.93f, 0.96f, 1.0f);
    const float light = 0.7f + 0.5f * smoothNoise(32, 16.0f * (x + rustle), 16.0f * y);
    return Eigen::Vector3f(0.22f, 0.38f, 0.14f) * light;
  };
  addPanel(panel, kCell, color, &mesh);
  return mesh;
}

}  // namespace markerless_mocap
