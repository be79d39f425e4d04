#include "segmentation/limbs/limb_borders.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr double kStretch = 0.1;  // cube roots of the hull's volume
constexpr size_t kStretches = 40;

/// Where limbs end. Ways in cube roots of the hull's volume, of clothed adults.
struct Widening {
  double earliest;  ///< way before which nothing is an end
  double front;     ///< share of the hull's nodes in the stretch at which the limb has ended
  double before;    ///< way that the end lies before that stretch
  double shortest;  ///< border of a whole one
  double least;     ///< share of the hull's nodes that a whole one has
};

constexpr Widening kHead{0.5, 0.018, 0.22, 0.3, 0.02};
// From an elbow on, the upper arm can be told from the trunk.
constexpr Widening kArm{0.4, 0.009, 0.0, 0.75, 0.01};
// Nothing before 1.6 is a leg's end, so that legs that pass each other and trousers fused down to
// the knees are shared out between both legs; a border below says that they are fused.
constexpr Widening kLeg{1.6, 0.032, 0.0, 1.56, 0.05};

// Shares of the way from a leg's tip to the head's at which legs of people end, any pose.
constexpr double kMinCrotch = 0.49;
constexpr double kMaxCrotch = 0.53;

const Widening& wideningOf(PartLabel limb) {
  if (limb == PartLabel::kHead) return kHead;
  return limb == PartLabel::kArm1 || limb == PartLabel::kArm2 ? kArm : kLeg;
}

/// Shares of the nodes in each stretch of the way, smoothed over three.
std::vector<double> frontsOf(const std::vector<double>& geodesic) {
  std::vector<double> counts(kStretches + 2, 0.0);
  for (const double w : geodesic)
    if (w < kStretch * kStretches) counts[size_t(w / kStretch) + 1] += 1.0;
  counts.front() = counts[1];
  counts.back() = counts[kStretches];
  std::vector<double> fronts;
  for (size_t i = 1; i <= kStretches; ++i)
    fronts.push_back((0.25 * counts[i - 1] + 0.5 * counts[i] + 0.25 * counts[i + 1]) /
                     double(geodesic.size()));
  return fronts;
}

}  // namespace

double limbBorder(PartLabel limb, const std::vector<double>& geodesic) {
  const Widening& widening = wideningOf(limb);
  const std::vector<double> fronts = frontsOf(geodesic);
  for (size_t i = size_t(widening.earliest / kStretch + 0.5); i < kStretches; ++i) {
    if (fronts[i] <= widening.front) continue;
    const double rise = fronts[i] - fronts[i - 1];
    const double fraction =
        rise > 0.0 ? std::max(0.0, (widening.front - fronts[i - 1]) / rise) : 0.0;
    return (double(i) - 0.5 + fraction) * kStretch - widening.before;
  }
  return kStretch * kStretches;
}

double legBorder(double border, double to_head) {
  return std::clamp(border, kMinCrotch * to_head, kMaxCrotch * to_head);
}

bool isWholeLimb(PartLabel limb, double border, double fraction) {
  const Widening& widening = wideningOf(limb);
  return border >= widening.shortest && fraction >= widening.least;
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
