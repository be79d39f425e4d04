#include "capture/sensor_noise.h"

#include <cmath>
#include <vector>

#include "capture/hash.h"

namespace markerless_mocap {
namespace {

constexpr size_t kTableSize = size_t(1) << 16;

/// Standard normal up to the fourth moment's error: sums of twelve uniform numbers.
std::vector<float> makeTable() {
  std::vector<float> table(kTableSize);
  for (size_t i = 0; i < kTableSize; ++i) {
    double sum = -6.0;
    for (size_t j = 0; j < 12; ++j) sum += hashUniform(12 * i + j);
    table[i] = float(sum);
  }
  return table;
}

}  // namespace

void addSensorNoise(double sigma_levels, uint64_t stream, cv::Mat& image) {
  if (sigma_levels == 0.0) return;
  static const std::vector<float> table = makeTable();
  const float sigma = float(sigma_levels);
  const int values = image.cols * image.channels();
  for (int y = 0; y < image.rows; ++y) {
    uint8_t* row = image.ptr<uint8_t>(y);
    // A row reads the table from a place of its own, by an odd step of its own.
    const uint64_t bits = hashBits(hashBits(stream) + uint64_t(y));
    const size_t start = bits % kTableSize, step = (bits >> 32) | 1u;
    for (int x = 0; x < values; ++x)
      row[x] = cv::saturate_cast<uint8_t>(
          row[x] + sigma * table[(start + size_t(x) * step) & (kTableSize - 1)]);
  }
}

}  // namespace markerless_mocap
