#include "exports/export_skeleton.h"

#include "evaluation/body_points.h"
#include "exports/point_names.h"

namespace markerless_mocap {
namespace {

struct Row {
  const char *point, *link;
  int parent;
  const char* end;  ///< name of a body point; empty: none
};
constexpr Row kRows[] = {
    {"pelvis", "body", -1, ""},
    {"waist", "r_waist", 0, ""},
    {"torso", "torso", 1, ""},
    {"thorax", "p_head", 2, ""},
    {"head", "head", 3, "head_top"},
    {"l_clavicle", "l_r_clavicle", 2, ""},
    {"l_shoulder", "l_shoulder", 5, ""},
    {"l_elbow", "l_elbow", 6, ""},
    {"l_wrist", "l_wrist", 7, "l_hand_tip"},
    {"r_clavicle", "r_r_clavicle", 2, ""},
    {"r_shoulder", "r_shoulder", 9, ""},
    {"r_elbow", "r_elbow", 10, ""},
    {"r_wrist", "r_wrist", 11, "r_hand_tip"},
    {"l_hip", "l_hip", 0, ""},
    {"l_knee", "l_knee", 13, ""},
    {"l_ankle", "l_ankle", 14, "l_foot_tip"},
    {"r_hip", "r_hip", 0, ""},
    {"r_knee", "r_knee", 16, ""},
    {"r_ankle", "r_ankle", 17, "r_foot_tip"},
};

LinkPoses tPose(const BodyModel& body) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(body.angleCount());
  for (const char* shoulder : {"l_p_shoulder", "r_p_shoulder"})  // away from the body
    angles[body.angleIndex(shoulder)] = M_PI_2;
  LinkPoses T_root_link;
  body.forwardKinematics(Eigen::Isometry3d::Identity(), angles, T_root_link);
  return T_root_link;
}

Eigen::Vector3d bodyPoint(const std::string& name, const Eigen::Matrix3Xd& points) {
  const std::vector<std::string> names = bodyPointNames();
  for (size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return points.col(Eigen::Index(i));
  throw std::invalid_argument("there is no body point " + name);
}

/// Rotation of a joint in its parent's axes, from rest.
Eigen::Quaterniond rotationOf(const ExportSkeleton& skeleton, const ExportJoint& joint,
                              const PersonFrame& frame) {
  const auto turn = [&](const ExportJoint& j) -> Eigen::Matrix3d {
    return frame.T_world_link[size_t(j.link)].linear() * j.R_rest.transpose();
  };
  if (joint.parent < 0) return Eigen::Quaterniond(turn(joint));
  const Eigen::Matrix3d R_world_parent = turn(skeleton[size_t(joint.parent)]);
  return Eigen::Quaterniond(Eigen::Matrix3d(R_world_parent.transpose() * turn(joint)));
}

void holdFirstBackwards(std::vector<JointRotations>* frames) {
  for (size_t j = 0; j < frames->front().known.size(); ++j) {
    size_t first = 0;
    while (first < frames->size() && !(*frames)[first].known[j]) ++first;
    if (first == frames->size()) continue;
    for (size_t f = 0; f < first; ++f) (*frames)[f].R_parent[j] = (*frames)[first].R_parent[j];
  }
}

/// The same rotation as the quaternion that is nearer to the last one.
Eigen::Quaterniond near(const Eigen::Quaterniond& last, Eigen::Quaterniond now) {
  if (last.dot(now) < 0) now.coeffs() = -now.coeffs();
  return now;
}

}  // namespace

ExportSkeleton exportSkeleton(const BodyModel& body, const std::string& names) {
  const LinkPoses rest = tPose(body);
  const Eigen::Matrix3Xd points = bodyPoints(body, rest);
  ExportSkeleton skeleton;
  for (const Row& row : kRows) {
    ExportJoint joint;
    joint.point = row.point;
    joint.name = nameOfPoint(names, row.point);
    joint.parent = row.parent;
    joint.link = body.linkIndex(row.link);
    joint.rest = rest[size_t(joint.link)].translation();
    joint.R_rest = rest[size_t(joint.link)].linear();
    joint.has_end = *row.end != '\0';
    if (joint.has_end) joint.end = bodyPoint(row.end, points);
    skeleton.push_back(joint);
  }
  return skeleton;
}

std::vector<JointRotations> jointRotations(const PersonMotion& motion,
                                           const ExportSkeleton& skeleton) {
  JointRotations now;
  now.root.setZero();
  now.R_parent.assign(skeleton.size(), Eigen::Quaterniond::Identity());
  std::vector<JointRotations> out;
  for (const PersonFrame& frame : motion.frames) {
    now.known.assign(skeleton.size(), false);
    if (frame.hasPose()) now.root = frame.T_world_link[0].translation();
    for (size_t j = 0; j < skeleton.size(); ++j) {
      if (!frame.isKnown(skeleton[j].link)) continue;
      now.R_parent[j] = near(now.R_parent[j], rotationOf(skeleton, skeleton[j], frame));
      now.known[j] = true;
    }
    out.push_back(now);
  }
  holdFirstBackwards(&out);
  return out;
}

std::vector<JointGap> jointGaps(const PersonMotion& motion, const ExportSkeleton& skeleton) {
  std::vector<JointGap> gaps;
  for (const ExportJoint& joint : skeleton) {
    bool open = false;
    for (size_t f = 0; f < motion.frames.size(); ++f) {
      const bool filled = motion.frames[f].filled[size_t(joint.link)];
      const bool seen = motion.frames[f].isKnown(joint.link) && !filled;
      if (!seen && (!open || gaps.back().filled != filled))
        gaps.push_back({joint.name, f, f, filled});
      if (!seen) gaps.back().last = f;
      open = !seen;
    }
  }
  return gaps;
}

}  // namespace markerless_mocap
