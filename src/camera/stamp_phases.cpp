#include "markerless_mocap/camera/stamp_phases.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr size_t kRemembered = 16, kEnough = 4;  // stamps of a stream
constexpr double kSameRate = 0.1;                // of the interval
constexpr double kStopped = 2.0 * kRemembered;   // intervals without a stamp

/// Mean time between two stamps, ns; frames may be missing.
double intervalOf(const std::deque<int64_t>& stamps) {
  std::vector<double> gaps;
  for (size_t i = 1; i < stamps.size(); ++i) gaps.push_back(double(stamps[i] - stamps[i - 1]));
  const double usual = medianOf(gaps);
  double frames = 0;
  for (const double gap : gaps) frames += std::max(1.0, std::round(gap / usual));
  return double(stamps.back() - stamps.front()) / frames;
}

/// Mean of the stamps on a circle of one interval, ns after `start_ns`, 0 to the interval.
double phaseOf(const std::deque<int64_t>& stamps, int64_t start_ns, double interval) {
  std::complex<double> sum = 0.0;
  for (const int64_t stamp : stamps)
    sum += std::polar(1.0, 2 * M_PI * double(stamp - start_ns) / interval);
  const double turns = std::arg(sum) / (2 * M_PI);
  return interval * (turns - std::floor(turns));
}

/// How many of the phases are in one part of the interval. \param phases ascending
size_t mostWithin(const std::vector<double>& phases, double part, double interval) {
  size_t most = 0;
  for (const double first : phases) {
    const auto within = std::count_if(phases.begin(), phases.end(), [&](double phase) {
      return (phase >= first ? phase : phase + interval) - first <= part;
    });
    most = std::max(most, size_t(within));
  }
  return most;
}

/// The longest part of the interval without a phase. \param phases ascending
double longestGap(const std::vector<double>& phases, double interval) {
  double longest = phases.front() + interval - phases.back();
  for (size_t i = 1; i < phases.size(); ++i) longest = std::max(longest, phases[i] - phases[i - 1]);
  return longest;
}

}  // namespace

struct StampPhases::Step {
  double interval, gap;  ///< ns
  bool most_in_step;
};

StampPhases::StampPhases(size_t streams, OutOfStep rule, int64_t tolerance_ns)
    : rule_(rule), least_ns_(tolerance_ns), tolerance_ns_(tolerance_ns), stamps_(streams) {}

void StampPhases::add(size_t stream, int64_t stamp_ns) {
  if (rule_ == OutOfStep::kLeaveOut) return;
  std::deque<int64_t>& stamps = stamps_[stream];
  if (!stamps.empty() && stamp_ns <= stamps.back()) return;
  stamps.push_back(stamp_ns);
  const bool begins = stamps.size() <= kRemembered;
  if (!begins) stamps.pop_front();
  if (++added_ >= stamps_.size() || begins) measure();  // once in a frame set
}

void StampPhases::reset() {
  for (std::deque<int64_t>& stamps : stamps_) stamps.clear();
  tolerance_ns_ = least_ns_;
  added_ = judged_ = 0;
  never_in_step_ = false;
}

std::vector<size_t> StampPhases::knownStreams() const {
  int64_t newest = 0;
  for (const auto& stamps : stamps_)
    if (!stamps.empty()) newest = std::max(newest, stamps.back());
  std::vector<size_t> known;
  for (size_t i = 0; i < stamps_.size(); ++i)
    if (stamps_[i].size() >= kEnough &&
        double(newest - stamps_[i].back()) < kStopped * intervalOf(stamps_[i]))
      known.push_back(i);
  return known;
}

std::optional<StampPhases::Step> StampPhases::step(const std::vector<size_t>& known) const {
  if (known.size() < 2) return std::nullopt;
  std::vector<double> intervals, phases;
  for (const size_t i : known) intervals.push_back(intervalOf(stamps_[i]));
  const double interval = medianOf(intervals);
  for (const double one : intervals)
    if (std::abs(one - interval) > kSameRate * interval) return std::nullopt;
  for (const size_t i : known)
    phases.push_back(phaseOf(stamps_[i], stamps_[known.front()].front(), interval));
  std::sort(phases.begin(), phases.end());
  const size_t in_step = mostWithin(phases, double(least_ns_), interval);
  return Step{interval, longestGap(phases, interval), 2 * in_step > known.size()};
}

void StampPhases::measure() {
  added_ = 0;
  const std::vector<size_t> known = knownStreams();
  const std::optional<Step> now = step(known);
  tolerance_ns_ = least_ns_;
  if (!now) return;
  if (known.size() > judged_) {
    judged_ = known.size();
    never_in_step_ = !now->most_in_step;
  }
  if (rule_ == OutOfStep::kJoinIfNever && !never_in_step_) return;
  const double part = now->interval - now->gap;
  if (part > double(least_ns_)) tolerance_ns_ = std::llround(part + now->gap / 2);
}

}  // namespace markerless_mocap
