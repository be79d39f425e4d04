#include "exports/person_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

PersonFrame frameWithoutPose(int64_t stamp_ns, size_t links) {
  PersonFrame frame;
  frame.stamp_ns = stamp_ns;
  frame.T_world_link.resize(links);
  for (Eigen::Isometry3d& link : frame.T_world_link) link.matrix().setConstant(NAN);
  frame.filled.assign(links, false);
  frame.part_sigma_m.fill(NAN);
  return frame;
}

int64_t medianStep(const std::vector<PersonFrame>& frames) {
  std::vector<int64_t> steps;
  for (size_t f = 1; f < frames.size(); ++f)
    steps.push_back(frames[f].stamp_ns - frames[f - 1].stamp_ns);
  if (steps.empty()) return 0;
  return medianAmong(steps);
}

void checkFrames(const std::vector<PersonFrame>& frames, size_t links) {
  for (size_t f = 0; f < frames.size(); ++f) {
    if (f > 0 && frames[f].stamp_ns <= frames[f - 1].stamp_ns)
      throw std::invalid_argument("the stamps of the frames do not ascend");
    if (!frames[f].T_world_link.empty() && frames[f].T_world_link.size() != links)
      throw std::invalid_argument("a frame has another number of links than the body");
  }
}

/// Adds frames without a pose where steps are missing.
std::vector<PersonFrame> withoutHoles(std::vector<PersonFrame> frames, size_t links) {
  const int64_t step = medianStep(frames);
  std::vector<PersonFrame> out;
  for (PersonFrame& frame : frames) {
    if (!out.empty()) {
      const int64_t last = out.back().stamp_ns, span = frame.stamp_ns - last;
      const int64_t steps = std::llround(double(span) / double(step));
      for (int64_t i = 1; i < steps; ++i)
        out.push_back(frameWithoutPose(last + span * i / steps, links));
    }
    if (frame.T_world_link.empty()) {
      out.push_back(frameWithoutPose(frame.stamp_ns, links));
    } else {
      frame.filled.assign(links, false);
      out.push_back(std::move(frame));
    }
  }
  return out;
}

}  // namespace

double PersonMotion::frameTime() const {
  constexpr double kUsual = 1.0 / 30.0;  // seconds
  return frames.size() < 2 ? kUsual : seconds(frames.size() - 1) / double(frames.size() - 1);
}

double PersonMotion::irregularity() const {
  double largest = 0.0;
  for (size_t f = 0; f < frames.size(); ++f)
    largest = std::max(largest, std::abs(seconds(f) - double(f) * frameTime()));
  return largest;
}

PersonMotion personMotion(std::shared_ptr<const BodyModel> body, std::vector<PersonFrame> frames) {
  const size_t links = body->links().size();
  checkFrames(frames, links);
  const auto has_pose = [](const PersonFrame& frame) { return frame.hasPose(); };
  const auto first = std::find_if(frames.begin(), frames.end(), has_pose);
  if (first == frames.end()) throw std::runtime_error("no frame has a pose");
  PersonMotion motion;
  motion.body = std::move(body);
  motion.start_s = 1e-9 * double(first->stamp_ns - frames.front().stamp_ns);
  const auto end = std::find_if(frames.rbegin(), frames.rend(), has_pose).base();
  motion.frames = withoutHoles({first, end}, links);
  return motion;
}

double jointAngle(const BodyJoint& joint, const PersonFrame& frame) {
  if (!frame.isKnown(joint.parent_link) || !frame.isKnown(joint.child_link)) return NAN;
  const Eigen::Matrix3d R =
      (frame.T_world_link[size_t(joint.parent_link)].linear() * joint.T_parent_joint.linear())
          .transpose() *
      frame.T_world_link[size_t(joint.child_link)].linear();
  const Eigen::Quaterniond turn(R);
  return std::remainder(2.0 * std::atan2(joint.axis.dot(turn.vec()), turn.w()), 2.0 * M_PI);
}

double misfit(const PersonMotion& motion) {
  double largest = 0.0;
  for (const PersonFrame& frame : motion.frames)
    for (const BodyJoint& joint : motion.body->joints()) {
      if (!frame.isKnown(joint.parent_link) || !frame.isKnown(joint.child_link)) continue;
      const Eigen::Vector3d expected =
          frame.T_world_link[size_t(joint.parent_link)] * joint.T_parent_joint.translation();
      const Eigen::Vector3d found = frame.T_world_link[size_t(joint.child_link)].translation();
      largest = std::max(largest, (found - expected).norm());
    }
  return largest;
}

}  // namespace markerless_mocap
