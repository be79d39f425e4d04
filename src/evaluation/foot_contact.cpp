#include "evaluation/foot_contact.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr double kMillimetres = 1e3;     // per metre
constexpr double kFloorFraction = 0.05;  // fraction of the heights; lower ones are outliers

double secondsBetween(int64_t from_ns, int64_t to_ns) {
  return double(to_ns - from_ns) * 1e-9;
}

double horizontal(const Eigen::Vector3d& offset) {
  return offset.head<2>().norm();
}

/// Height of the points of both sides at rest; NaN without points.
double restHeight(const JointTrack& both) {
  std::vector<double> heights;
  for (const Eigen::Matrix3Xd& points : both.positions)
    for (Eigen::Index side = 0; side < points.cols(); ++side)
      if (std::isfinite(points(2, side))) heights.push_back(points(2, side));
  if (heights.empty()) return NAN;
  return quantileAmong(heights, kFloorFraction);
}

/// Speed over up to half of kContactSpan_s to either side, as far as the point is known; NaN if it
/// is not known.
double speedAt(const JointTrack& track, Eigen::Index column, size_t frame) {
  constexpr double kReach = 0.5 * kContactSpan_s + 1e-6;
  const auto& stamps = track.stamps_ns;
  const auto known = [&](size_t f) { return track.positions[f].col(column).allFinite(); };
  if (!known(frame)) return NAN;
  size_t from = frame, to = frame;
  while (from > 0 && secondsBetween(stamps[from - 1], stamps[frame]) <= kReach && known(from - 1))
    --from;
  while (to + 1 < stamps.size() && secondsBetween(stamps[frame], stamps[to + 1]) <= kReach &&
         known(to + 1))
    ++to;
  if (from == to) return NAN;
  return (track.positions[to].col(column) - track.positions[from].col(column)).norm() /
         secondsBetween(stamps[from], stamps[to]);
}

std::vector<ContactRun> runsOf(const std::vector<bool>& resting,
                               const std::vector<int64_t>& stamps_ns) {
  std::vector<ContactRun> runs;
  for (size_t f = 0; f < resting.size(); ++f) {
    if (!resting[f]) continue;
    if (f == 0 || !resting[f - 1]) runs.push_back({f, 0, 0.0});
    ContactRun& run = runs.back();
    ++run.frames;
    run.seconds = secondsBetween(stamps_ns[run.first], stamps_ns[f]);
  }
  return runs;
}

/// Per frame, whether the first of the two points rests.
std::vector<bool> restingFrames(const JointTrack& both) {
  const double max_height = restHeight(both) + kContactRise_m;
  std::vector<bool> resting;
  for (size_t f = 0; f < both.frames(); ++f)
    resting.push_back(both.positions[f](2, 0) <= max_height &&
                      speedAt(both, 0, f) <= kContactSpeed_m_s);
  for (const ContactRun& run : runsOf(resting, both.stamps_ns))
    if (run.seconds < kMinContact_s - 1e-6)
      std::fill_n(resting.begin() + std::ptrdiff_t(run.first), run.frames, false);
  return resting;
}

/// Maximum horizontal distance from the first known position, and path length per time.
std::pair<double, double> travelled(const JointTrack& track, const ContactRun& run) {
  double reach = NAN, path = 0.0, seconds = 0.0;
  size_t first = 0, last = 0;
  for (size_t f = run.first; f < run.first + run.frames; ++f) {
    const Eigen::Vector3d now = track.positions[f].col(0);
    if (!now.allFinite()) continue;
    if (std::isnan(reach)) {
      first = f;
      reach = 0.0;
    } else {
      reach = std::max(reach, horizontal(now - track.positions[first].col(0)));
      path += horizontal(now - track.positions[last].col(0));
      seconds += secondsBetween(track.stamps_ns[last], track.stamps_ns[f]);
    }
    last = f;
  }
  return {kMillimetres * reach, seconds > 0.0 ? kMillimetres * path / seconds : NAN};
}

SummaryStatistics spreadOfSlides(const std::vector<FootSkate>& slides, double FootSkate::*figure) {
  std::vector<double> values;
  for (const FootSkate& slide : slides) values.push_back(slide.*figure);
  return summaryStatistics(values);
}

void evaluateAgreement(const JointTrack& truth, const JointTrack& estimate, FootContact* out) {
  size_t said = 0, real = 0, both = 0;
  for (size_t f = 0; f < truth.frames(); ++f) {
    if (!truth.positions[f].col(0).allFinite() || !estimate.positions[f].col(0).allFinite())
      continue;
    said += out->estimate[f];
    real += out->truth[f];
    both += out->estimate[f] && out->truth[f];
  }
  out->precision = said == 0 ? NAN : double(both) / double(said);
  out->recall = real == 0 ? NAN : double(both) / double(real);
}

}  // namespace

FootContact footContact(const JointTrack& truth, const JointTrack& estimate,
                        const std::string& name) {
  if (truth.stamps_ns != estimate.stamps_ns)
    throw std::invalid_argument("contacts need truth and estimate of the same frames");
  const std::vector<std::string> sides{name, otherSide(name)};
  const JointTrack real = truth.select(sides), found = estimate.select(sides);
  FootContact out;
  out.name = name;
  out.truth = restingFrames(real);
  out.estimate = restingFrames(found);
  evaluateAgreement(real, found, &out);
  for (const ContactRun& run : runsOf(out.truth, real.stamps_ns)) {
    const auto [reach, path] = travelled(found, run);
    const auto [true_reach, true_path] = travelled(real, run);
    out.contacts.push_back({run, reach, path, true_reach, true_path});
  }
  out.max_slide_mm = spreadOfSlides(out.contacts, &FootSkate::max_slide_mm);
  out.path_mm_per_s = spreadOfSlides(out.contacts, &FootSkate::path_mm_per_s);
  out.true_max_slide_mm = spreadOfSlides(out.contacts, &FootSkate::true_max_slide_mm);
  out.true_path_mm_per_s = spreadOfSlides(out.contacts, &FootSkate::true_path_mm_per_s);
  return out;
}

SoleStatistics soleStatistics(const std::vector<double>& heights_m,
                              const std::vector<bool>& resting) {
  if (heights_m.size() != resting.size())
    throw std::invalid_argument("soles need one height and one contact per frame");
  SoleStatistics out;
  std::vector<double> standing;
  size_t below = 0;
  double sum = 0.0, deepest = 0.0;
  for (size_t f = 0; f < heights_m.size(); ++f) {
    const double height = kMillimetres * heights_m[f];
    if (!std::isfinite(height)) continue;
    ++out.frames;
    below += height < -kPenetrationLimit_mm;
    sum += std::max(0.0, -height);
    deepest = std::max(deepest, -height);
    if (resting[f]) standing.push_back(height);
  }
  const double frames = out.frames == 0 ? NAN : double(out.frames);
  out.fraction_below = double(below) / frames;
  out.mean_below_mm = sum / frames;
  out.deepest_mm = out.frames == 0 ? NAN : deepest;
  out.standing_mm = summaryStatistics(standing);
  return out;
}

}  // namespace markerless_mocap
