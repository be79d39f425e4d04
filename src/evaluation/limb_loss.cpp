#include "evaluation/limb_loss.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kMillimetres = 1e3;  // per metre

/// First frame with an estimate; the number of frames if there is none.
size_t firstPose(const JointTrack& estimate) {
  size_t f = 0;
  while (f < estimate.frames() && !estimate.positions[f].array().isFinite().any()) ++f;
  return f;
}

/// Counts the runs of lost frames and finds the longest; runs close to each other count as one. A
/// run lasts until the next frame in which the limb is not lost.
void countLosses(const std::vector<int64_t>& stamps_ns, LimbLoss* limb) {
  const auto at = [&](size_t f) {
    return double(stamps_ns[std::min(f, stamps_ns.size() - 1)] - stamps_ns[0]) * 1e-9;
  };
  double begin = 0.0, end = -kSameLoss_s;
  for (size_t f = 0; f < limb->lost.size(); ++f) {
    if (!limb->lost[f]) continue;
    if (limb->losses == 0 || at(f) - end >= kSameLoss_s - 1e-9) {
      begin = at(f);
      ++limb->losses;
    }
    end = at(f + 1);
    limb->longest_s = std::max(limb->longest_s, end - begin);
  }
}

LimbLoss limbLoss(const JointTrack& truth, const JointTrack& estimate, size_t first,
                  const std::string& name, const std::string& end) {
  const JointTrack real = truth.select({end}), found = estimate.select({end});
  LimbLoss limb;
  limb.limb = name;
  limb.end = end;
  limb.lost.assign(truth.frames(), false);
  for (size_t f = first; f < truth.frames(); ++f) {
    if (!real.positions[f].allFinite()) continue;
    ++limb.frames;
    const bool published = found.positions[f].allFinite();
    const bool far = published && kMillimetres * (found.positions[f] - real.positions[f]).norm() >
                                      kExtremityLimit_mm;
    limb.not_published += !published;
    limb.far_off += far;
    limb.lost[f] = !published || far;
  }
  countLosses(truth.stamps_ns, &limb);
  const double seconds = first + 1 < truth.frames()
                             ? double(truth.stamps_ns.back() - truth.stamps_ns[first]) * 1e-9
                             : NAN;
  limb.per_minute = 60.0 * double(limb.losses) / seconds;
  limb.fraction_lost =
      limb.frames == 0 ? NAN : double(limb.far_off + limb.not_published) / double(limb.frames);
  return limb;
}

}  // namespace

std::vector<LimbLoss> limbLosses(const JointTrack& truth, const JointTrack& estimate) {
  if (truth.stamps_ns != estimate.stamps_ns)
    throw std::invalid_argument("losses of limbs need truth and estimate of the same frames");
  const size_t first = firstPose(estimate);
  std::vector<LimbLoss> limbs;
  for (const auto& [name, end] : {std::pair{"head", "head"},
                                  {"left_arm", "l_wrist"},
                                  {"right_arm", "r_wrist"},
                                  {"left_leg", "l_ankle"},
                                  {"right_leg", "r_ankle"}})
    limbs.push_back(limbLoss(truth, estimate, first, name, end));
  return limbs;
}

}  // namespace markerless_mocap
