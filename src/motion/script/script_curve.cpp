#include "motion/script/script_curve.h"

#include <algorithm>
#include <stdexcept>

namespace markerless_mocap {
namespace {

/// Slope at a key between two chords: 0 at a turning point, else their weighted harmonic mean.
double slopeBetween(double chord_before, double chord_after, double span_before,
                    double span_after) {
  if (chord_before * chord_after <= 0.0) return 0.0;
  const double w_before = 2.0 * span_after + span_before;
  const double w_after = span_after + 2.0 * span_before;
  return (w_before + w_after) / (w_before / chord_before + w_after / chord_after);
}

}  // namespace

ScriptCurve::ScriptCurve() : ScriptCurve(CurveValues::Zero(1)) {}

ScriptCurve::ScriptCurve(const CurveValues& values)
    : ScriptCurve(std::vector<CurveKey>{{0.0, values}}) {}

ScriptCurve::ScriptCurve(std::vector<CurveKey> keys) : keys_(std::move(keys)) {
  if (keys_.empty()) throw std::invalid_argument("a curve needs at least one key");
  for (size_t i = 1; i < keys_.size(); ++i) {
    if (!(keys_[i].seconds > keys_[i - 1].seconds))
      throw std::invalid_argument("a curve's times must rise");
    if (keys_[i].values.size() != keys_[0].values.size())
      throw std::invalid_argument("a curve's keys must have the same count of values");
  }
  slopes_.assign(keys_.size(), CurveValues::Zero(keys_[0].values.size()));
  for (size_t i = 1; i + 1 < keys_.size(); ++i) {
    const double before = keys_[i].seconds - keys_[i - 1].seconds;
    const double after = keys_[i + 1].seconds - keys_[i].seconds;
    for (Eigen::Index j = 0; j < slopes_[i].size(); ++j)
      slopes_[i][j] =
          slopeBetween((keys_[i].values[j] - keys_[i - 1].values[j]) / before,
                       (keys_[i + 1].values[j] - keys_[i].values[j]) / after, before, after);
  }
}

CurveValues ScriptCurve::at(double seconds) const {
  if (seconds <= keys_.front().seconds) return keys_.front().values;
  if (seconds >= keys_.back().seconds) return keys_.back().values;
  const auto after =
      std::upper_bound(keys_.begin(), keys_.end(), seconds,
                       [](double time, const CurveKey& key) { return time < key.seconds; });
  const size_t i = size_t(after - keys_.begin()) - 1;
  const double span = keys_[i + 1].seconds - keys_[i].seconds;
  const double u = (seconds - keys_[i].seconds) / span;
  const double u2 = u * u, u3 = u2 * u;
  return (2.0 * u3 - 3.0 * u2 + 1.0) * keys_[i].values +
         (3.0 * u2 - 2.0 * u3) * keys_[i + 1].values + (u3 - 2.0 * u2 + u) * span * slopes_[i] +
         (u3 - u2) * span * slopes_[i + 1];
}

}  // namespace markerless_mocap
