#include "motion/gait/gait_clearance.h"

#include <algorithm>

#include "motion/gait/gait_swing.h"
#include "numerics/segment.h"

namespace markerless_mocap {
namespace {

constexpr double kStep = 0.005;       // step of the search, metres
constexpr double kMaxDistance = 0.4;  // metres
constexpr double kShoeWidth = 0.056;  // fraction of the stature

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

FootClearance::FootClearance(const HumanSkeleton& skeleton)
    : heel_x_(-0.028 * skeleton.stature),
      toe_x_(skeleton.tailOf(Bone::kLeftToes).x() - skeleton.headOf(Bone::kLeftFoot).x()),
      shoe_width_(kShoeWidth * skeleton.stature) {}

double FootClearance::gap(const GroundPose& foot, const GroundPose& other) const {
  const Eigen::Vector2d a = foot.shifted(heel_x_, 0.0).position;
  const Eigen::Vector2d b = foot.shifted(toe_x_, 0.0).position;
  const Eigen::Vector2d c = other.shifted(heel_x_, 0.0).position;
  const Eigen::Vector2d d = other.shifted(toe_x_, 0.0).position;
  const bool crossing = cross(b - a, c - a) * cross(b - a, d - a) < 0.0 &&
                        cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
  if (crossing) return 0.0;
  return std::min(std::min(distanceToSegment(a, c, d), distanceToSegment(b, c, d)),
                  std::min(distanceToSegment(c, a, b), distanceToSegment(d, a, b)));
}

GroundPose FootClearance::beside(const GroundPose& place, const GroundPose& other) const {
  const double middle = 0.5 * (heel_x_ + toe_x_);
  const Eigen::Vector2d apart =
      place.shifted(middle, 0.0).position - other.shifted(middle, 0.0).position;
  GroundPose moved = place;
  for (double moved_by = 0.0; gap(moved, other) < shoe_width_ && moved_by < kMaxDistance;
       moved_by += kStep)
    moved.position += kStep * apart.normalized();
  return moved;
}

double FootClearance::closest(const GroundPose& from, const GroundPose& to, const GroundPose& other,
                              const Eigen::Vector2d& detour) const {
  double min_gap = 1e9;
  for (int i = 0; i <= 20; ++i)
    min_gap = std::min(min_gap, gap(swingPose(from, to, detour, i / 20.0), other));
  return min_gap;
}

Eigen::Vector2d FootClearance::detour(bool left, const GroundPose& from, const GroundPose& to,
                                      const GroundPose& other) const {
  // If a foot begins or ends nearer than a shoe's width, this distance cannot be kept in between.
  const double wanted = std::min({shoe_width_, gap(from, other), gap(to, other)}) - 1e-3;
  if (closest(from, to, other, Eigen::Vector2d::Zero()) >= wanted) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d offset = to.position - from.position;
  const Eigen::Vector2d outward = left ? other.left() : Eigen::Vector2d(-other.left());
  Eigen::Vector2d aside =
      offset.norm() > 0.05 ? Eigen::Vector2d(-offset.y(), offset.x()).normalized() : outward;
  if (aside.dot(outward) < 0.0) aside = -aside;  // legs do not cross
  for (double size = kStep; size < kMaxDistance; size += kStep)
    if (closest(from, to, other, size * aside) >= wanted) return size * aside;
  return Eigen::Vector2d::Zero();
}

}  // namespace markerless_mocap
