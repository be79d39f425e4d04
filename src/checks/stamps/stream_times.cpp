#include "checks/stamps/stream_times.h"

#include <algorithm>
#include <cmath>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

/// An interval longer than this many periods is a gap.
constexpr double kGap = 1.6;
/// Standard deviation of a normal distribution by its quartiles.
constexpr double kQuartilesToSigma = 1.349;

void countOrder(const std::vector<SeenImage>& images, StreamTimes* times) {
  for (size_t i = 0; i < images.size(); ++i) {
    times->zero += images[i].stamp_ns == 0;
    if (i == 0 || images[i].stamp_ns == 0 || images[i - 1].stamp_ns == 0) continue;
    const int64_t step = images[i].stamp_ns - images[i - 1].stamp_ns;
    times->backwards += step < 0;
    times->doubled += step == 0;
    times->worst_back = std::max(times->worst_back, -1e-9 * step);
  }
}

/// From one image to the next, s; not where stamps are zero, go back, or return from there.
std::vector<double> intervalsOf(const std::vector<SeenImage>& images) {
  std::vector<double> intervals;
  int64_t newest = 0;
  for (size_t i = 1; i < images.size(); ++i) {
    newest = std::max(newest, images[i - 1].stamp_ns);
    const int64_t step = images[i].stamp_ns - images[i - 1].stamp_ns;
    const bool usable = images[i].stamp_ns != 0 && images[i - 1].stamp_ns != 0 && step > 0;
    if (usable && images[i - 1].stamp_ns == newest) intervals.push_back(1e-9 * double(step));
  }
  return intervals;
}

void countGaps(const std::vector<double>& intervals, StreamTimes* times) {
  for (const double interval : intervals) {
    if (interval < kGap * times->period) continue;
    const int missing = int(std::lround(interval / times->period)) - 1;
    times->missing += missing;
    times->longest_gap = std::max(times->longest_gap, missing);
  }
}

/// Of the second differences, which a rate that changes slowly leaves small: jitter of independent
/// stamps has their standard deviation times sqrt(6).
double jitterOf(const std::vector<double>& intervals, double period) {
  std::vector<double> bends;
  for (size_t i = 1; i < intervals.size(); ++i)
    if (intervals[i] < kGap * period && intervals[i - 1] < kGap * period)
      bends.push_back(intervals[i] - intervals[i - 1]);
  return (nearestQuantile(bends, 0.75) - nearestQuantile(bends, 0.25)) / kQuartilesToSigma /
         std::sqrt(6.0);
}

void measureDelays(const std::vector<SeenImage>& images, StreamTimes* times) {
  std::vector<double> delays;
  for (const SeenImage& image : images)
    if (image.stamp_ns != 0) delays.push_back(1e-9 * double(image.received_ns - image.stamp_ns));
  times->delay = nearestQuantile(delays, 0.5);
  times->delay_spread = nearestQuantile(delays, 0.95) - nearestQuantile(delays, 0.05);
}

}  // namespace

StreamTimes timesOf(const std::vector<SeenImage>& images) {
  StreamTimes times;
  countOrder(images, &times);
  for (const SeenImage& image : images) {
    if (image.stamp_ns == 0) continue;
    times.first_ns =
        times.first_ns == 0 ? image.stamp_ns : std::min(times.first_ns, image.stamp_ns);
    times.last_ns = std::max(times.last_ns, image.stamp_ns);
  }
  measureDelays(images, &times);
  const std::vector<double> intervals = intervalsOf(images);
  if (intervals.size() < 2) return times;
  times.period = nearestQuantile(intervals, 0.5);
  countGaps(intervals, &times);
  times.jitter = jitterOf(intervals, times.period);
  return times;
}

Repeats repeatsOf(const std::vector<SeenImage>& images) {
  Repeats repeats;
  int run = 0;
  for (size_t i = 1; i < images.size(); ++i) {
    const bool same =
        images[i].fingerprint != 0 && images[i].fingerprint == images[i - 1].fingerprint;
    run = same ? run + 1 : 0;
    repeats.images += same;
    repeats.longest = std::max(repeats.longest, run);
  }
  return repeats;
}

}  // namespace markerless_mocap
