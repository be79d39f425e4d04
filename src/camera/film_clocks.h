#pragma once

#include <cstddef>
#include <vector>

namespace markerless_mocap {

/// Offsets between films that were started by hand, s: what is searched for unless told otherwise.
constexpr double kLargestFilmOffset = 60.0;
/// How many times as much must speak for an offset as for any other one, to be certain.
constexpr double kCertainOffset = 1.7;

/// What is known beforehand of when films began.
enum class FilmStart { kUnknown, kTogether, kApart };

/// When films began, by what moves in them.
struct FilmClocks {
  /// s, to be added to the clock of each film; one of them has 0. NaN: it shares too little with
  /// the others.
  std::vector<double> offsets;
  /// What speaks for a film's offset, divided by what speaks for the best of all clearly different
  /// ones. Below kCertainOffset the offset is not certain, below 1 it is wrong.
  std::vector<double> certainty;
  /// Part of what speaks for the offsets that speaks for none, too: 1 if the films began together.
  double for_none = 0.0;

  bool certain() const {
    for (const double one : certainty)
      if (!(one >= kCertainOffset)) return false;
    return true;
  }
};

/// The highest value near an index, divided by the highest one beyond the valleys to its sides (at
/// half its height): how much a peak stands out. 0 if nothing is above 0 there.
double peakRatio(const std::vector<double>& values, size_t peak);

}  // namespace markerless_mocap
