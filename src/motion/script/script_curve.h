#pragma once

#include <Eigen/Core>
#include <vector>

namespace markerless_mocap {

/// The values of a track at one time.
using CurveValues = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;

struct CurveKey {
  double seconds = 0.0;
  CurveValues values;  ///< 1 to 6 numbers
};

/// Smooth curves through keys: once differentiable, each value monotone between two keys, with
/// slope 0 at turning points, so that it never overshoots (Fritsch and Carlson 1980, with the
/// slopes of Fritsch and Butland 1984). Constant before the first and after the last key.
class ScriptCurve {
 public:
  /// One value, constant 0.
  ScriptCurve();
  /// Constant.
  explicit ScriptCurve(const CurveValues& values);
  /// Throws std::invalid_argument if there is no key, if times do not ascend, or if keys differ in
  /// their number of values.
  explicit ScriptCurve(std::vector<CurveKey> keys);

  CurveValues at(double seconds) const;
  const std::vector<CurveKey>& keys() const { return keys_; }

 private:
  std::vector<CurveKey> keys_;
  std::vector<CurveValues> slopes_;  ///< of each key, per second
};

}  // namespace markerless_mocap
