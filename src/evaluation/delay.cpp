#include "evaluation/delay.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace markerless_mocap {
namespace {

constexpr size_t kMinFrames = 10;
constexpr double kMinChange = 0.01;  // minimum relative change of D over the shifts
constexpr int kStepsPerFrame = 8;
/// The truth is not interpolated between frames further apart than this many frame times.
constexpr double kMaxGap = 3.5;

/// The truth interpolated at a time; false outside its range.
bool truthAtTime(const JointTrack& truth, double at_ns, double max_gap_ns,
                 Eigen::Matrix3Xd* points) {
  const auto after = std::lower_bound(truth.stamps_ns.begin(), truth.stamps_ns.end(), at_ns,
                                      [](int64_t stamp, double at) { return double(stamp) < at; });
  if (after == truth.stamps_ns.end()) return false;
  const size_t next = size_t(after - truth.stamps_ns.begin());
  if (double(*after) == at_ns) {
    *points = truth.positions[next];
    return true;
  }
  if (next == 0) return false;
  const double step = double(*after - truth.stamps_ns[next - 1]);
  if (step > max_gap_ns) return false;
  const double fraction = (at_ns - double(truth.stamps_ns[next - 1])) / step;
  *points = (1.0 - fraction) * truth.positions[next - 1] + fraction * truth.positions[next];
  return true;
}

/// Mean D of the frames `used` against the truth `delay_ns` earlier; NaN unless all of them have
/// truth.
double meanD(const JointTrack& truth, const JointTrack& estimate, const std::vector<size_t>& used,
             double delay_ns) {
  const double widest = kMaxGap * double(frameTime(truth.stamps_ns));
  double sum = 0.0;
  size_t frames = 0;
  Eigen::Matrix3Xd points;
  for (const size_t f : used) {
    if (!truthAtTime(truth, double(estimate.stamps_ns[f]) - delay_ns, widest, &points)) continue;
    const Eigen::RowVectorXd distance = (estimate.positions[f] - points).colwise().norm();
    double frame_sum = 0.0;
    int markers = 0;
    for (const double d : distance)
      if (std::isfinite(d)) frame_sum += d, ++markers;
    if (markers > 0) sum += frame_sum / markers, ++frames;
  }
  return frames == 0 ? NAN : 1e3 * sum / double(frames);
}

/// Frames that stay inside the truth's range under all shifts.
std::vector<size_t> innerFrames(const JointTrack& truth, const JointTrack& estimate,
                                double max_ns) {
  std::vector<size_t> used;
  for (size_t f = 0; f < estimate.frames(); ++f) {
    const auto stamp = double(estimate.stamps_ns[f]);
    const bool estimated = estimate.positions[f].array().isFinite().any();
    if (estimated && stamp - max_ns >= double(truth.stamps_ns.front()) &&
        stamp + max_ns <= double(truth.stamps_ns.back()))
      used.push_back(f);
  }
  return used;
}

/// Position of the minimum of the parabola through three neighbours, in steps from the middle one.
double parabolaMinimum(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  return curvature > 0.0 ? 0.5 * (before - after) / curvature : 0.0;
}

}  // namespace

Delay estimateDelay(const JointTrack& truth, const JointTrack& estimate, double max_seconds) {
  const Delay unknown{NAN, NAN, NAN};
  const JointTrack found = estimate.select(truth.names);
  const double frame_ns = double(frameTime(truth.stamps_ns));
  if (!(frame_ns > 0.0)) return unknown;
  const std::vector<size_t> used = innerFrames(truth, found, max_seconds * 1e9);
  if (used.size() < kMinFrames) return unknown;

  const double step_ns = frame_ns / kStepsPerFrame;
  const int steps = int(max_seconds * 1e9 / step_ns);
  std::vector<double> D;
  for (int k = -steps; k <= steps; ++k) D.push_back(meanD(truth, found, used, k * step_ns));
  const auto range = std::minmax_element(D.begin(), D.end());
  if (!(*range.second - *range.first > kMinChange * *range.second)) return unknown;
  const auto best = int(range.first - D.begin());
  const bool inside = best > 0 && best < 2 * steps;
  const double fine = inside ? parabolaMinimum(D[best - 1], D[best], D[best + 1]) : 0.0;
  return {(best - steps + fine) * step_ns * 1e-9, D[steps], *range.first};
}

}  // namespace markerless_mocap
