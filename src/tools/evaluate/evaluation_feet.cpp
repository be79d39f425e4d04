#include "tools/evaluate/evaluation_feet.h"

#include <cmath>

#include "evaluation/body_points.h"

namespace markerless_mocap {
namespace {

std::vector<double> heightsOf(const JointTrack& track, const std::string& point) {
  const JointTrack some = track.select({point});
  std::vector<double> heights;
  for (const Eigen::Matrix3Xd& points : some.positions) heights.push_back(1e3 * points(2, 0));
  return heights;
}

/// Heights of the sole of one foot at the frames of the ground truth; NaN without a pose or without
/// the URDF of the tracked body.
std::vector<double> solesOf(const ResultRecord& results, const std::vector<int>& match, int side) {
  std::vector<double> heights;
  for (const int index : match) {
    const bool known = index >= 0 && results.has_description &&
                       !results.frames[size_t(index)].T_world_link.empty();
    heights.push_back(
        known ? soleHeights(*results.body, results.frames[size_t(index)].T_world_link)[side] : NAN);
  }
  return heights;
}

}  // namespace

FeetEvaluation evaluateFeet(const JointTrack& truth, const ResultRecord& results,
                            const std::vector<int>& match) {
  const JointTrack found = alignedTo(truth, results.joints);
  FeetEvaluation feet;
  for (int side = 0; side < 2; ++side) {
    const std::string prefix = side == 0 ? "l_" : "r_";
    FootEvaluation& foot = feet[size_t(side)];
    foot.ball = footContact(truth, found, prefix + "foot");
    foot.ankle = footContact(truth, found, prefix + "ankle");
    foot.sole_m = solesOf(results, match, side);
    foot.sole = soleStatistics(foot.sole_m, foot.ball.truth);
    foot.true_ball_mm = heightsOf(truth, prefix + "foot");
    foot.ball_mm = heightsOf(found, prefix + "foot");
  }
  return feet;
}

}  // namespace markerless_mocap
