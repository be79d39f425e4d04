#include <cmath>
#include <functional>

#include "exports/person_motion.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// The known frames around a gap. `before` and `after` are `from` and `to` where no more is known.
struct Gap {
  size_t before, from, to, after;
};

/// Gaps between known frames that are at most `seconds` apart.
std::vector<Gap> gapsOf(const PersonMotion& motion, const std::function<bool(size_t)>& known,
                        double seconds) {
  constexpr double kRounding_s = 1e-6;
  const size_t count = motion.frames.size();
  std::vector<Gap> gaps;
  for (size_t from = 0; from + 1 < count; ++from) {
    if (!known(from) || known(from + 1)) continue;
    size_t to = from + 1;
    while (to < count && !known(to)) ++to;
    if (to == count || motion.seconds(to) - motion.seconds(from) > seconds + kRounding_s) continue;
    gaps.push_back({from > 0 && known(from - 1) ? from - 1 : from, from, to,
                    to + 1 < count && known(to + 1) ? to + 1 : to});
  }
  return gaps;
}

/// Cubic Hermite spline from gap.from to gap.to; its slopes are those of the chords to the next
/// known frame on either side.
VectorXd spline(const PersonMotion& motion, const Gap& gap, size_t frame,
                const std::function<VectorXd(size_t)>& value) {
  const auto slope = [&](size_t a, size_t b) -> VectorXd {
    return (value(b) - value(a)) / (motion.seconds(b) - motion.seconds(a));
  };
  const double span = motion.seconds(gap.to) - motion.seconds(gap.from);
  const double u = (motion.seconds(frame) - motion.seconds(gap.from)) / span;
  const VectorXd begin = slope(gap.before, gap.before == gap.from ? gap.to : gap.from) * span;
  const VectorXd end = slope(gap.after == gap.to ? gap.from : gap.to, gap.after) * span;
  const double u2 = u * u, u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * value(gap.from) + (u3 - 2 * u2 + u) * begin +
         (3 * u2 - 2 * u3) * value(gap.to) + (u3 - u2) * end;
}

void setLink(int link, const Eigen::Isometry3d& T_world_link, PersonFrame* frame) {
  frame->T_world_link[size_t(link)] = T_world_link;
  frame->filled[size_t(link)] = true;
}

/// Rotations are rotation vectors from that of the gap's beginning.
void fillRoot(double seconds, PersonMotion* motion) {
  const auto known = [&](size_t f) { return motion->frames[f].hasPose(); };
  for (const Gap& gap : gapsOf(*motion, known, seconds)) {
    const Eigen::Isometry3d start = motion->frames[gap.from].T_world_link[0];
    const auto value = [&](size_t f) -> VectorXd {
      const Eigen::Isometry3d& T = motion->frames[f].T_world_link[0];
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(start.linear().transpose() * T.linear()));
      return (VectorXd(6) << T.translation(), turn.angle() * turn.axis()).finished();
    };
    for (size_t f = gap.from + 1; f < gap.to; ++f) {
      const VectorXd place = spline(*motion, gap, f, value);
      const Vector3d turn = place.tail<3>();
      Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
      T.linear() = start.linear();
      if (turn.norm() > 0)
        T.linear() = T.linear() * Eigen::AngleAxisd(turn.norm(), turn.normalized());
      T.translation() = place.head<3>();
      setLink(0, T, &motion->frames[f]);
    }
  }
}

/// The way between angles is the shorter one.
void fillJoint(const BodyJoint& joint, double seconds, PersonMotion* motion) {
  const auto known = [&](size_t f) {
    const PersonFrame& frame = motion->frames[f];
    return frame.isKnown(joint.child_link) && !frame.filled[size_t(joint.child_link)];
  };
  for (const Gap& gap : gapsOf(*motion, known, seconds)) {
    const double start = jointAngle(joint, motion->frames[gap.from]);
    const auto value = [&](size_t f) -> VectorXd {
      const double turn = jointAngle(joint, motion->frames[f]) - start;
      return VectorXd::Constant(1, std::remainder(turn, 2 * M_PI));
    };
    for (size_t f = gap.from + 1; f < gap.to; ++f) {
      PersonFrame& frame = motion->frames[f];
      if (!frame.isKnown(joint.parent_link)) continue;
      const double angle = start + spline(*motion, gap, f, value)[0];
      setLink(joint.child_link,
              frame.T_world_link[size_t(joint.parent_link)] * joint.T_parent_joint *
                  Eigen::AngleAxisd(joint.angle_index < 0 ? 0.0 : angle, joint.axis),
              &frame);
    }
  }
}

}  // namespace

void fillGaps(double seconds, PersonMotion* motion) {
  motion->fill_s = seconds;
  fillRoot(seconds, motion);
  for (const BodyJoint& joint : motion->body->joints()) fillJoint(joint, seconds, motion);
}

}  // namespace markerless_mocap
