#include <algorithm>
#include <cmath>

#include "body/rotations.h"
#include "exports/motion_description.h"
#include "exports/point_names.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kDegrees = 180.0 / M_PI;
constexpr double kShortestLever_m = 0.05;  // below, a limb's end says nothing about the angle

/// Interpolated linearly between the values; NaN without any.
double percentile(std::vector<double> values, double fraction) {
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  return interpolatedQuantile(values, fraction);
}

/// The end of the part that a joint moves: its expected error is known.
NamedPoint endOf(const std::string& joint) {
  const std::string side = joint.substr(0, 2);
  for (const char* word : {"clavicle", "shoulder", "elbow"})
    if (joint.find(word) != std::string::npos) return {"", side + "wrist", "", 0};
  for (const char* word : {"hip", "knee"})
    if (joint.find(word) != std::string::npos) return {"", side + "ankle", "", 0};
  if (joint.find("head") != std::string::npos) return {"", "head", "", 0};
  if (joint.find("waist") != std::string::npos) return {"", "thorax", "", 0};
  return {"", "", "", 0};
}

/// Expected error of an angle in one frame, radians: that of the end across its distance from the
/// axis; NaN: unknown.
double angleError(const BodyJoint& joint, const NamedPoint& end, const BodyModel& body,
                  const PersonFrame& frame) {
  const int end_link = linkOf(end, body);
  if (end_link < 0 || !frame.isKnown(end_link) || !frame.isKnown(joint.child_link)) return NAN;
  const Eigen::Isometry3d& T_world_joint = frame.T_world_link[size_t(joint.child_link)];
  const Vector3d axis = T_world_joint.linear() * joint.axis;
  const Vector3d arm =
      frame.T_world_link[size_t(end_link)].translation() - T_world_joint.translation();
  const double lever = axis.cross(arm).norm();
  if (lever < kShortestLever_m) return NAN;
  return expectedError(end, frame) / std::sqrt(3.0) / lever;
}

JointRange rangeOf(const PersonMotion& motion, const BodyJoint& joint, const std::string& name) {
  const NamedPoint end = endOf(name);
  std::vector<double> angles, errors;
  for (const PersonFrame& frame : motion.frames) {
    const double angle = jointAngle(joint, frame);
    if (!std::isfinite(angle)) continue;
    angles.push_back(angles.empty() ? angle : nearestTurn(angle, angles.back()));
    const double error = angleError(joint, end, *motion.body, frame);
    if (std::isfinite(error)) errors.push_back(error);
  }
  const double low = kDegrees * percentile(angles, 0.01);
  const double high = kDegrees * percentile(angles, 0.99);
  const bool known = 2 * errors.size() >= angles.size();
  const double error = known ? kDegrees * std::sqrt(2.0) * percentile(errors, 0.5) : double(NAN);
  return {name, low, high, {high - low, error}};
}

}  // namespace

std::vector<JointRange> jointRanges(const PersonMotion& motion) {
  const size_t suffix = motion.body->id().size() + 1;
  std::vector<JointRange> ranges;
  for (const BodyJoint& joint : motion.body->joints())
    if (joint.angle_index >= 0)
      ranges.push_back(rangeOf(motion, joint, joint.name.substr(0, joint.name.size() - suffix)));
  return ranges;
}

TrunkLean trunkLean(const PersonMotion& motion) {
  const size_t torso = size_t(motion.body->linkIndex("torso"));
  std::vector<Measure> forward, left;
  std::vector<double> forwards, lefts;
  for (const PersonFrame& frame : motion.frames) {
    if (!frame.hasPose() || !frame.isKnown(int(torso))) continue;
    const Vector3d trunk =
        frame.T_world_link[torso].translation() - frame.T_world_link[0].translation();
    const Vector3d chest = frame.T_world_link[0].linear().col(0);
    const double heading = std::atan2(chest.y(), chest.x());
    const Vector3d seen = rotZ(-heading) * trunk;
    const double error = kDegrees * frame.part_sigma_m[0] / std::sqrt(3.0) / trunk.norm();
    forwards.push_back(kDegrees * std::atan2(seen.x(), seen.z()));
    lefts.push_back(kDegrees * std::atan2(seen.y(), seen.z()));
    forward.push_back({forwards.back(), error});
    left.push_back({lefts.back(), error});
  }
  return {averageOf(forward),         averageOf(left),         percentile(forwards, 0.01),
          percentile(forwards, 0.99), percentile(lefts, 0.01), percentile(lefts, 0.99)};
}

}  // namespace markerless_mocap
