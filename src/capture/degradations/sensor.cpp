#include "capture/degradations/sensor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/split_mix.h"

namespace markerless_mocap {
namespace {

constexpr double kBeatHz = 0.7;  // beat of mains and frame rate
constexpr size_t kTableSize = size_t(1) << 16;
constexpr size_t kChunk = 128;  // values read from the table at once

/// Sum of twelve uniform numbers, shifted: mean 0, standard deviation 1.
double nearNormal(uint64_t stream) {
  double sum = -6.0;
  for (uint64_t i = 0; i < 12; ++i) sum += splitMixUniform(stream + i);
  return sum;
}

/// One chunk longer than its size, so that any start is valid.
std::vector<float> makeTable() {
  std::vector<float> table(kTableSize + kChunk);
  for (size_t i = 0; i < table.size(); ++i) table[i] = float(nearNormal(12 * i));
  return table;
}

void applyToChunk(float noise_stddev, float gain, const float* noise, size_t count,
                  uint8_t* values) {
  for (size_t i = 0; i < count; ++i) {
    const float level = gain * float(values[i]) + noise_stddev * noise[i] + 0.5f;
    values[i] = uint8_t(int(std::min(std::max(level, 0.0f), 255.0f)));
  }
}

}  // namespace

double flickerGain(double amount, double seconds, uint64_t stream) {
  const double phase = splitMixUniform(splitMix64(stream));
  const double beat = std::sqrt(2.0) * std::sin(2.0 * M_PI * (kBeatHz * seconds + phase));
  const auto frame_set = uint64_t(std::llround(seconds * 1e6));
  const double random = nearNormal(splitMix64(splitMix64(stream + 1) ^ frame_set));
  return std::max(0.0, 1.0 + amount * std::sqrt(0.5) * (beat + random));
}

void applySensor(double noise_stddev, double gain, uint64_t stream, cv::Mat& image) {
  if (noise_stddev == 0.0 && gain == 1.0) return;
  static const std::vector<float> table = makeTable();
  const uint64_t key = splitMix64(stream);
  const size_t values = size_t(image.cols) * image.channels();
  uint64_t chunk = 0;
  for (int y = 0; y < image.rows; ++y) {
    uint8_t* const row = image.ptr<uint8_t>(y);
    for (size_t x = 0; x < values; x += kChunk)
      applyToChunk(float(noise_stddev), float(gain), &table[splitMix64(key + chunk++) % kTableSize],
                   std::min(kChunk, values - x), row + x);
  }
}

}  // namespace markerless_mocap
