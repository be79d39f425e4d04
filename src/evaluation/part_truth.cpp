#include "evaluation/part_truth.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "numerics/segment.h"

namespace markerless_mocap {
namespace {

enum Point {
  kPelvis,
  kThorax,
  kHead,
  kHeadTop,
  kShoulder,
  kElbow,
  kWrist,
  kHandTip,
  kHip,
  kKnee,
  kAnkle,
  kFootTip,  // left; the right's follow
};
constexpr int kSided = 8;

}  // namespace

const std::vector<std::string>& partTruthNames() {
  static const std::vector<std::string> names{
      "pelvis",     "thorax",     "head",   "head_top", "l_shoulder", "l_elbow",    "l_wrist",
      "l_hand_tip", "l_hip",      "l_knee", "l_ankle",  "l_foot_tip", "r_shoulder", "r_elbow",
      "r_wrist",    "r_hand_tip", "r_hip",  "r_knee",   "r_ankle",    "r_foot_tip"};
  return names;
}

PartTruth::PartTruth(const Eigen::Matrix3Xd& points) {
  if (points.cols() != Eigen::Index(partTruthNames().size()) || !points.allFinite())
    throw std::invalid_argument("true parts need finite positions of all of " +
                                std::to_string(partTruthNames().size()) + " points");
  const Eigen::Vector3d hip = points.col(kHip), knee = points.col(kKnee);
  const double leg = (hip - knee).norm() + (knee - points.col(kAnkle)).norm();
  // Half widths of adults as fractions of the leg's length.
  const auto add = [&](int a, int b, double radius, int part, bool distal, bool axis) {
    bones_.push_back({points.col(a), points.col(b), radius * leg, uint8_t(part), distal, axis});
  };
  add(kPelvis, kThorax, 0.14, TruePart::kTorso, false, true);
  add(kThorax, kHeadTop, 0.09, TruePart::kHead, false, true);
  for (const int side : {0, 1}) {
    const int p = side * kSided, arm = TruePart::kLeftArm + side, legs = TruePart::kLeftLeg + side;
    add(kHip + p, kShoulder + p, 0.11, TruePart::kTorso, false, false);
    add(kShoulder + p, kElbow + p, 0.06, arm, false, true);
    add(kElbow + p, kWrist + p, 0.05, arm, true, true);
    add(kWrist + p, kHandTip + p, 0.045, arm, true, true);
    add(kHip + p, kKnee + p, 0.10, legs, false, true);
    add(kKnee + p, kAnkle + p, 0.065, legs, true, true);
    add(kAnkle + p, kFootTip + p, 0.055, legs, true, true);
  }
}

const PartTruth::Bone& PartTruth::nearestBone(const Eigen::Vector3d& point) const {
  const Bone* nearest = &bones_.front();
  double min_distance = std::numeric_limits<double>::infinity();
  for (const Bone& bone : bones_) {
    const double distance = distanceToSegment(point, bone.a, bone.b) - bone.radius;
    if (distance >= min_distance) continue;
    min_distance = distance;
    nearest = &bone;
  }
  return *nearest;
}

uint8_t PartTruth::partAt(const Eigen::Vector3d& point) const {
  return nearestBone(point).part;
}

bool PartTruth::isDistal(const Eigen::Vector3d& point) const {
  return nearestBone(point).distal;
}

double PartTruth::toAxis(const Eigen::Vector3d& point, int part) const {
  double min_distance = std::numeric_limits<double>::infinity();
  for (const Bone& bone : bones_)
    if (bone.part == part && bone.axis)
      min_distance = std::min(min_distance, distanceToSegment(point, bone.a, bone.b));
  return min_distance;
}

}  // namespace markerless_mocap
