#include "segmentation/limbs/limb_borders.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr double kInterval = 0.1;  // cube roots of the hull's volume
constexpr size_t kIntervals = 40;

/// Where limbs end. Distances from the extremity, in cube roots of the hull's volume; values for
/// clothed adults.
struct Widening {
  double earliest;    ///< minimum distance of the border
  double front;       ///< the limb has ended at the interval with this fraction of the hull's nodes
  double before;      ///< distance of the border before that interval
  double min_border;  ///< minimum border of a whole limb
  double min_fraction;  ///< minimum fraction of the hull's nodes of a whole limb
};

constexpr Widening kHead{0.5, 0.018, 0.22, 0.3, 0.02};
// A whole arm reaches at least to the elbow, from where the upper arm can be separated from the
// trunk.
constexpr Widening kArm{0.4, 0.009, 0.0, 0.75, 0.01};
// A leg does not end before 1.6, so that legs that touch, and trousers merged down to the knees,
// are divided between both legs. A smaller border means that the legs are merged.
constexpr Widening kLeg{1.6, 0.032, 0.0, 1.56, 0.05};

// Legs end between these fractions of the distance from the foot's extremity to the head's, in any
// pose.
constexpr double kMinCrotch = 0.49;
constexpr double kMaxCrotch = 0.53;

const Widening& wideningOf(PartLabel limb) {
  if (limb == PartLabel::kHead) return kHead;
  return limb == PartLabel::kArm1 || limb == PartLabel::kArm2 ? kArm : kLeg;
}

/// Fractions of the nodes in each interval of the distance, smoothed over three intervals.
std::vector<double> frontsOf(const std::vector<double>& geodesic) {
  std::vector<double> counts(kIntervals + 2, 0.0);
  for (const double w : geodesic)
    if (w < kInterval * kIntervals) counts[size_t(w / kInterval) + 1] += 1.0;
  counts.front() = counts[1];
  counts.back() = counts[kIntervals];
  std::vector<double> fronts;
  for (size_t i = 1; i <= kIntervals; ++i)
    fronts.push_back((0.25 * counts[i - 1] + 0.5 * counts[i] + 0.25 * counts[i + 1]) /
                     double(geodesic.size()));
  return fronts;
}

}  // namespace

double limbBorder(PartLabel limb, const std::vector<double>& geodesic) {
  const Widening& widening = wideningOf(limb);
  const std::vector<double> fronts = frontsOf(geodesic);
  for (size_t i = size_t(widening.earliest / kInterval + 0.5); i < kIntervals; ++i) {
    if (fronts[i] <= widening.front) continue;
    const double rise = fronts[i] - fronts[i - 1];
    const double fraction =
        rise > 0.0 ? std::max(0.0, (widening.front - fronts[i - 1]) / rise) : 0.0;
    return (double(i) - 0.5 + fraction) * kInterval - widening.before;
  }
  return kInterval * kIntervals;
}

double legBorder(double border, double to_head) {
  return std::clamp(border, kMinCrotch * to_head, kMaxCrotch * to_head);
}

bool isWholeLimb(PartLabel limb, double border, double fraction) {
  const Widening& widening = wideningOf(limb);
  return border >= widening.min_border && fraction >= widening.min_fraction;
}

std::array<std::vector<uint32_t>, kPartCount> nodesOfLimbs(
    const std::array<std::vector<double>, kPartCount>& geodesic,
    const std::array<double, kPartCount>& border) {
  std::vector<double> least;
  std::vector<int> owner;
  for (int part = 1; part < kPartCount; ++part) {
    if (geodesic[part].empty()) continue;
    least.resize(geodesic[part].size(), 1.0);
    owner.resize(geodesic[part].size(), 0);
    for (size_t node = 0; node < geodesic[part].size(); ++node) {
      const double fraction = geodesic[part][node] / border[part];
      if (fraction >= least[node]) continue;
      least[node] = fraction;
      owner[node] = part;
    }
  }
  std::array<std::vector<uint32_t>, kPartCount> nodes;
  for (uint32_t node = 0; node < owner.size(); ++node)
    if (owner[node] > 0) nodes[owner[node]].push_back(node);
  return nodes;
}

}  // namespace markerless_mocap
