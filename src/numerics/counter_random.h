#pragma once

#include <cmath>
#include <cstdint>

#include "numerics/split_mix.h"

namespace markerless_mocap {

/// Random numbers that depend on a seed and on where they are used, not on the order of use, so
/// that threads cannot change them (SplitMix64's finaliser; Steele et al. 2014).
class CounterRandom {
 public:
  explicit CounterRandom(uint64_t seed) : key_(splitMix64(seed)) {}
  /// Numbers of their own for a part of the work.
  CounterRandom stream(uint64_t part) const { return CounterRandom(key_ ^ splitMix64(~part)); }

  /// In [0, 1).
  double uniform(uint64_t counter) const { return splitMixUniform(key_ + counter); }
  /// In [lowest, highest).
  double between(double lowest, double highest, uint64_t counter) const {
    return lowest + (highest - lowest) * uniform(counter);
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
