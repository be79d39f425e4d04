#pragma once

#include <cmath>
#include <cstdint>

#include "numerics/split_mix.h"

namespace markerless_mocap {

/// Counter-based random numbers: they depend on a seed and a counter and not on the order of calls,
/// so results do not depend on threads (finaliser of SplitMix64; Steele et al. 2014).
class CounterRandom {
 public:
  explicit CounterRandom(uint64_t seed) : key_(splitMix64(seed)) {}
  /// An independent stream of numbers for a part of the work.
  CounterRandom stream(uint64_t part) const { return CounterRandom(key_ ^ splitMix64(~part)); }

  /// Uniform in [0, 1).
  double uniform(uint64_t counter) const { return splitMixUniform(key_ + counter); }
  /// Uniform in [low, high).
  double between(double low, double high, uint64_t counter) const {
    return low + (high - low) * uniform(counter);
  }
  /// Standard normal (Box and Muller 1958).
  double normal(uint64_t counter) const {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(2 * counter)));
    return radius * std::cos(2.0 * M_PI * uniform(2 * counter + 1));
  }

 private:
  uint64_t key_;
};

}  // namespace markerless_mocap
