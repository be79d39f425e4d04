#include "capture/scene/room_texture.h"

#include <algorithm>
#include <cmath>

#include "capture/scene/value_noise.h"
#include "numerics/split_mix.h"

namespace markerless_mocap {
namespace {

constexpr float kSkirting = 0.12f;  // height, metres
constexpr float kGroove = 0.006f;   // metres on each side of the gap between boards

uint64_t combinedHash(uint64_t seed, int64_t a, int64_t b, int64_t c = 0) {
  return splitMix64(seed ^ splitMix64(uint64_t(a) * 0x9e3779b97f4a7c15u ^
                                      splitMix64(uint64_t(b) * 0xc2b2ae3d27d4eb4fu ^ uint64_t(c))));
}

/// A sequence of random numbers.
struct RandomStream {
  uint64_t state;
  float uniform(float low, float high) {
    return low + (high - low) * float(splitMixUniform(state++));
  }
  int below(int count) { return int(splitMix64(state++) % uint64_t(count)); }
};

/// \param strongest maximum saturation
Eigen::Vector3f paint(RandomStream& rng, float strongest) {
  const float hue = rng.uniform(0.0f, 6.0f), strength = rng.uniform(0.1f, strongest);
  const float bright = rng.uniform(0.25f, 0.9f);
  const auto wave = [&](float at) {
    const float d = std::abs(std::remainder(hue - at, 6.0f));
    return bright * (1.0f - strength * std::clamp(d - 1.0f, 0.0f, 1.0f));
  };
  return {wave(0.0f), wave(2.0f), wave(4.0f)};
}

}  // namespace

RoomTexture::RoomTexture(uint64_t seed, const Eigen::Vector3f& half_size)
    : seed_(splitMix64(seed)), half_size_(half_size) {
  RandomStream rng{combinedHash(seed_, 1, 2)};
  const float base = rng.uniform(0.56f, 0.70f);
  for (Eigen::Vector3f& color : wall_colors_)
    for (float& channel : color) channel = base + rng.uniform(-0.05f, 0.05f);
  const float wood = rng.uniform(0.48f, 0.60f);
  wood_ << wood, wood * rng.uniform(0.86f, 0.91f), wood * rng.uniform(0.70f, 0.84f);
  boards_along_x_ = rng.below(2) == 0;
  board_width_ = rng.uniform(0.18f, 0.32f);
  for (int wall = 0; wall < 4; ++wall) panels_[wall] = hangPanels(wall, half_size_[1 - wall / 2]);
}

std::vector<RoomTexture::Panel> RoomTexture::hangPanels(int wall, float half_length) const {
  RandomStream rng{combinedHash(seed_, 3, wall)};
  std::vector<Panel> panels;
  const float top = half_size_.z();
  const auto hang = [&](float strongest, float middle, float width, float low, float height) {
    Panel panel{
        middle - width / 2,    middle + width / 2,    low,  std::min(low + height, top - 0.1f),
        paint(rng, strongest), paint(rng, strongest), 0.0f, 0.0f};
    if (rng.below(3) == 0) panel.stripe = rng.uniform(0.05f, 0.15f);
    if (rng.below(2) == 0) panel.frame = rng.uniform(0.03f, 0.07f);
    panels.push_back(panel);
  };
  hang(0.3f, rng.uniform(-0.8f, 0.8f) * half_length, rng.uniform(0.8f, 1.0f), 0.0f,
       2.05f);  // door
  for (int i = 0; i < 2; ++i)
    hang(0.4f, rng.uniform(-0.8f, 0.8f) * half_length, rng.uniform(0.9f, 1.8f),
         rng.uniform(0.8f, 1.1f), rng.uniform(0.9f, 1.3f));  // windows
  const int pictures = 4 + rng.below(5);
  for (int i = 0; i < pictures; ++i)
    hang(0.85f, rng.uniform(-0.95f, 0.95f) * half_length, rng.uniform(0.25f, 1.2f),
         rng.uniform(0.3f, 0.8f * top), rng.uniform(0.2f, 0.8f));
  return panels;
}

Eigen::Vector3f RoomTexture::floorColor(const Eigen::Vector3f& point, float blur) const {
  const float along = boards_along_x_ ? point.x() : point.y();
  const float across = boards_along_x_ ? point.y() : point.x();
  const int board = floorOf(across / board_width_);
  const float length = 1.6f, shift = length * float(splitMixUniform(combinedHash(seed_, 5, board)));
  const int piece = floorOf((along + shift) / length);
  const float tone = float(splitMixUniform(combinedHash(seed_, 6, board, piece))) - 0.5f;
  float light = 1.0f + 0.36f * tone;
  light += 0.10f * fractalNoise(seed_ + 11, along / 4.0f, across, 0.12f, 4);
  light += 0.08f * fractalNoise(seed_ + 12, point.x(), point.y(), 1.5f, 3);
  const float from_side = across - float(board) * board_width_;
  const float from_end = along + shift - float(piece) * length;
  const float to_gap = std::min({from_side, board_width_ - from_side, from_end, length - from_end});
  const float width = std::max(kGroove, blur);
  light *= 1.0f - 0.45f * (kGroove / width) * (1.0f - std::min(to_gap / width, 1.0f));
  const float from_middle = point.head<2>().norm() / half_size_.head<2>().minCoeff();
  return wood_ * (light * (1.05f - 0.15f * std::min(from_middle, 1.5f)));
}

Eigen::Vector3f RoomTexture::wallColorAt(int wall, float along, float height) const {
  if (height < kSkirting) return wall_colors_[wall] * 0.55f;
  Eigen::Vector3f color = wall_colors_[wall];
  for (const Panel& panel : panels_[wall]) {
    const float inside = std::min({along - panel.along_low, panel.along_high - along,
                                   height - panel.low, panel.high - height});
    if (inside < 0.0f) continue;
    color = panel.color;
    if (inside < panel.frame)
      color = Eigen::Vector3f::Constant(0.3f);
    else if (panel.stripe > 0.0f && std::fmod(height, 2 * panel.stripe) < panel.stripe)
      color = panel.second;
  }
  const float up = height / half_size_.z();
  const uint64_t seed = seed_ + 100 * uint64_t(wall + 1);
  float light = 0.88f + 0.2f * up;
  light += 0.07f * fractalNoise(seed, along, height, 0.9f, 3);
  light += 0.07f * fractalNoise(seed + 7, along, height * 1.8f, 0.10f, 3);
  return color * light;
}

Eigen::Vector3f RoomTexture::color(const Eigen::Vector3f& point, int axis, bool upper,
                                   float blur) const {
  Eigen::Vector3f color;
  if (axis < 2)
    color = wallColorAt(2 * axis + int(upper), point[1 - axis], point.z());
  else if (upper)
    color = Eigen::Vector3f::Constant(
        0.78f + 0.03f * fractalNoise(seed_ + 13, point.x(), point.y(), 0.6f, 4));
  else
    color = floorColor(point, blur);
  return color.cwiseMax(0.0f).cwiseMin(1.0f);
}

Eigen::Vector3f RoomTexture::wallColor() const {
  return (wall_colors_[0] + wall_colors_[1] + wall_colors_[2] + wall_colors_[3]) / 4.0f;
}

}  // namespace markerless_mocap
