#include "character/body/loft.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "character/body/signed_distance.h"

namespace markerless_mocap {
namespace {

constexpr int kSamples = 256;
using Numbers = std::array<double, 5>;

Numbers numbersOf(const LoftSection& s) {
  return {s.side_centre, s.front_centre, s.side, s.front, s.back};
}

LoftSection sectionOf(double at, const Numbers& n) {
  return {at, n[0], n[1], n[2], n[3], n[4]};
}

/// Slope at the knot between two chords: 0 at an extremum, so that the curve does not overshoot
/// (Fritsch and Butland 1984).
double knotSlope(double before, double after, double h_before, double h_after) {
  if (before * after <= 0.0) return 0.0;
  const double w1 = 2.0 * h_after + h_before, w2 = h_after + 2.0 * h_before;
  return (w1 + w2) / (w1 / before + w2 / after);
}

double chord(const std::vector<LoftSection>& sections, size_t i, size_t n) {
  return (numbersOf(sections[i + 1])[n] - numbersOf(sections[i])[n]) /
         (sections[i + 1].at - sections[i].at);
}

std::vector<Numbers> knotSlopes(const std::vector<LoftSection>& sections) {
  const size_t last = sections.size() - 1;
  std::vector<Numbers> slopes(sections.size());
  for (size_t n = 0; n < Numbers().size(); ++n) {
    for (size_t i = 1; i < last; ++i)
      slopes[i][n] =
          knotSlope(chord(sections, i - 1, n), chord(sections, i, n),
                    sections[i].at - sections[i - 1].at, sections[i + 1].at - sections[i].at);
    slopes[0][n] = chord(sections, 0, n);
    slopes[last][n] = chord(sections, last - 1, n);
  }
  return slopes;
}

/// Cubic Hermite interpolation between two knots.
double hermite(double a, double b, double slope_a, double slope_b, double h, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * h * slope_a + (3 * t2 - 2 * t3) * b +
         (t3 - t2) * h * slope_b;
}

}  // namespace

Loft::Loft(LoftAxes axes, const std::vector<LoftSection>& sections, double square, double end_round)
    : axes_(axes), square_(square), end_round_(end_round) {
  begin_ = sections.front().at;
  end_ = sections.back().at;
  per_metre_ = kSamples / (end_ - begin_);
  const std::vector<Numbers> slopes = knotSlopes(sections);
  size_t i = 0;
  for (int k = 0; k <= kSamples; ++k) {
    const double at = begin_ + k / per_metre_;
    while (i + 2 < sections.size() && at > sections[i + 1].at) ++i;
    const double h = sections[i + 1].at - sections[i].at, t = (at - sections[i].at) / h;
    const Numbers a = numbersOf(sections[i]), b = numbersOf(sections[i + 1]);
    Numbers now;
    for (size_t n = 0; n < now.size(); ++n)
      now[n] = hermite(a[n], b[n], slopes[i][n], slopes[i + 1][n], h, t);
    samples_.push_back(sectionOf(at, now));
  }
}

double Loft::distance(const Eigen::Vector3d& p) const {
  const double t = p[axes_.along];
  const double place = std::clamp((t - begin_) * per_metre_, 0.0, double(kSamples) - 1e-6);
  const size_t i = size_t(place);
  const double f = place - double(i);
  const LoftSection &a = samples_[i], &b = samples_[i + 1];
  const auto mix = [f](double x, double y) { return x + f * (y - x); };
  const double u = p[axes_.side] - mix(a.side_centre, b.side_centre);
  const double w = p[axes_.front] - mix(a.front_centre, b.front_centre);
  const double half_u = mix(a.side, b.side);
  const double half_w = w > 0 ? mix(a.front, b.front) : mix(a.back, b.back);
  const double u2 = u * u / (half_u * half_u), w2 = w * w / (half_w * half_w);
  const double oval = std::sqrt(u2 + w2);
  const double e = oval + square_ * (std::sqrt(std::sqrt(u2 * u2 + w2 * w2)) - oval);
  const double radius = std::sqrt(u * u + w * w);
  const double within = e > 1e-6 ? radius * (1.0 - 1.0 / e) : -std::min(half_u, half_w);
  const double beyond = std::max(begin_ - t, t - end_);
  if (within > 0.0 && beyond > 0.0) return std::sqrt(within * within + beyond * beyond);
  return smoothIntersection(within, beyond, end_round_);
}

}  // namespace markerless_mocap
