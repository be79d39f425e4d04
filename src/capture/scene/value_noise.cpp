#include "capture/scene/value_noise.h"

#include <cstddef>
#include <vector>

#include "numerics/split_mix.h"

namespace markerless_mocap {
namespace {

/// Random numbers from -1 to 1 at the corners of a periodic grid.
class Lattice {
 public:
  Lattice() : values_(size_t(kSide) * kSide) {
    for (size_t i = 0; i < values_.size(); ++i) values_[i] = float(2.0 * splitMixUniform(i) - 1.0);
  }
  /// \param seed shifts the grid
  float at(uint64_t seed, int x, int y) const {
    return values_[((uint32_t(y) + uint32_t(seed >> 8)) % kSide) * kSide +
                   (uint32_t(x) + uint32_t(seed)) % kSide];
  }

 private:
  static constexpr uint32_t kSide = 256;
  std::vector<float> values_;
};

}  // namespace

float smoothNoise(uint64_t seed, float x, float y) {
  static const Lattice lattice;
  const int ix = floorOf(x), iy = floorOf(y);
  const float u = x - float(ix), v = y - float(iy);
  const float su = u * u * (3 - 2 * u), sv = v * v * (3 - 2 * v);
  const float upper = lattice.at(seed, ix, iy) * (1 - su) + lattice.at(seed, ix + 1, iy) * su;
  const float lower =
      lattice.at(seed, ix, iy + 1) * (1 - su) + lattice.at(seed, ix + 1, iy + 1) * su;
  return upper * (1 - sv) + lower * sv;
}

float fractalNoise(uint64_t seed, float x, float y, float size, int octaves) {
  float sum = 0.0f, amplitude = 0.6f, scale = 1.0f / size;
  for (int i = 0; i < octaves; ++i, amplitude *= 0.65f, scale *= 2.1f)
    sum += amplitude * smoothNoise(splitMix64(seed + uint64_t(i)), x * scale, y * scale);
  return sum;
}

}  // namespace markerless_mocap
