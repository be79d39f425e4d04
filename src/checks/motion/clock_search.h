#pragma once

#include <array>
#include <vector>

#include "checks/motion/explanation.h"

namespace markerless_mocap {

/// By how much a camera's clock is wrong at the middle of the recording, and how that grows.
struct ClockError {
  double offset = 0;     ///< s, to be added to the stamps
  double drift = 0;      ///< s per s
  double deviation = 0;  ///< one standard deviation of the drift, or of a constant offset
};

/// How well the rays of a camera meet the points of the others, for a table of clock offsets. An
/// offset that grows with time is read from the same table. The deviations are those of a
/// jackknife over parts of the recording (Efron 1982), so parts in which nobody moves do no harm.
class ClockSearch {
 public:
  /// \param state the camera's rays, and points by all others
  /// \param largest offset from that of `camera`, either way, and \param step of the table, s
  ClockSearch(const RigSight& sight, const CameraModel& camera, const CameraState& state,
              double largest, double step);

  /// Loss of the usual offset minus that of the best: whether motion shows times at all.
  double sharpness() const;
  /// The best constant offset.
  ClockError offset() const;
  /// The best offset and drift together. \param most_drift s per s, either way
  ClockError offsetAndDrift(double most_drift) const;
  double middle() const { return middle_; }  ///< s, as RigSight::moments

 private:
  static constexpr size_t kParts = 10;
  /// Losses of one offset and drift, by part of the recording.
  struct Sums {
    std::array<double, kParts> loss{};
    std::array<int, kParts> rays{};
    double mean(size_t left_out) const;
  };
  using Row = std::vector<Sums>;  // of all offsets of the table
  /// \param rows of drifts drift_step apart, as many to either side of 0
  ClockError best(const std::vector<Row>& rows, double drift_step, size_t left_out) const;
  ClockError errorOf(const std::vector<Row>& rows, double drift_step) const;

  void add(const Sight& pixels, double offset);
  Row rowOf(double drift) const;
  void addRay(size_t ray, double drift, Row* row) const;

  const RigSight& sight_;
  const CameraModel& camera_;
  const CameraState& state_;
  double step_, middle_;
  std::vector<double> offsets_;              // ascending, by step_
  std::vector<std::vector<double>> losses_;  // [offset][ray]; NaN: the ray or its point is missing
};

}  // namespace markerless_mocap
