#include "markerless_mocap/body/body_model.h"

#include <algorithm>
#include <stdexcept>

#include "body/urdf/urdf_reader.h"

namespace markerless_mocap {
namespace {

/// Markers of the error measure and the links whose origins they are.
struct Marker {
  const char* name;
  const char* link;
};
constexpr Marker kMarkers[] = {
    {"pelvis", "body"},           {"thorax", "r_head"},   {"head", "head"},
    {"l_shoulder", "l_shoulder"}, {"l_elbow", "l_elbow"}, {"l_wrist", "l_wrist"},
    {"r_shoulder", "r_shoulder"}, {"r_elbow", "r_elbow"}, {"r_wrist", "r_wrist"},
    {"l_hip", "l_hip"},           {"l_knee", "l_knee"},   {"l_ankle", "l_ankle"},
    {"r_hip", "r_hip"},           {"r_knee", "r_knee"},   {"r_ankle", "r_ankle"}};

}  // namespace

BodyModel BodyModel::fromUrdf(const std::string& urdf_xml, const std::string& id) {
  BodyTree tree = readBodyTree(urdf_xml, id);
  BodyModel model;
  model.id_ = id;
  model.links_ = std::move(tree.links);
  model.joints_ = std::move(tree.joints);
  model.shape_ = std::move(tree.shape);
  model.T_root_link_zero_.assign(model.links_.size(), Eigen::Isometry3d::Identity());
  for (BodyJoint& joint : model.joints_) {
    Eigen::Isometry3d& T_root_joint = model.T_root_link_zero_[joint.child_link];
    T_root_joint = model.T_root_link_zero_[joint.parent_link] * joint.T_parent_joint;
    if (joint.angle_index < 0) continue;
    joint.twist = Twist::revolute(T_root_joint.linear() * joint.axis, T_root_joint.translation());
    ++model.angle_count_;
  }
  return model;
}

int BodyModel::linkIndex(const std::string& base_name) const {
  const auto found = std::find(links_.begin(), links_.end(), base_name + "_" + id_);
  if (found == links_.end())
    throw std::invalid_argument("body " + id_ + " has no link " + base_name);
  return int(found - links_.begin());
}

const BodyJoint& BodyModel::joint(const std::string& base_name) const {
  const std::string name = base_name + "_" + id_;
  const auto found = std::find_if(joints_.begin(), joints_.end(),
                                  [&](const BodyJoint& joint) { return joint.name == name; });
  if (found == joints_.end())
    throw std::invalid_argument("body " + id_ + " has no joint " + base_name);
  return *found;
}

int BodyModel::angleIndex(const std::string& joint_base_name) const {
  const int index = joint(joint_base_name).angle_index;
  if (index < 0)
    throw std::invalid_argument("joint " + joint_base_name + " of body " + id_ +
                                " is fixed and has no angle");
  return index;
}

std::vector<std::string> BodyModel::angleNames() const {
  std::vector<std::string> names(angle_count_);
  for (const BodyJoint& joint : joints_)
    if (joint.angle_index >= 0) names[joint.angle_index] = joint.name;
  return names;
}

void BodyModel::forwardKinematics(const Eigen::Isometry3d& T_world_root,
                                  const Eigen::VectorXd& angles, LinkPoses& T_world_link) const {
  if (angles.size() != angle_count_)
    throw std::invalid_argument("body " + id_ + " has " + std::to_string(angle_count_) +
                                " joint angles, " + std::to_string(angles.size()) + " were given");
  T_world_link.resize(links_.size());
  // First the product of exponentials of each link's chain ...
  T_world_link[0] = T_world_root;
  for (const BodyJoint& joint : joints_) {
    const Eigen::Isometry3d& product = T_world_link[joint.parent_link];
    T_world_link[joint.child_link] =
        joint.angle_index < 0 ? product
                              : product * exponential(joint.twist, angles[joint.angle_index]);
  }
  // ... then its pose at zero angles: g(theta) = exp(xi_1 theta_1) ... exp(xi_n theta_n) g(0).
  for (size_t link = 0; link < links_.size(); ++link)
    T_world_link[link] = T_world_link[link] * T_root_link_zero_[link];
}

const std::vector<std::string>& markerNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const Marker& marker : kMarkers) out.push_back(marker.name);
    return out;
  }();
  return names;
}

std::vector<Eigen::Vector3d> markerPositions(const BodyModel& model,
                                             const LinkPoses& T_world_link) {
  std::vector<Eigen::Vector3d> positions;
  for (const Marker& marker : kMarkers)
    positions.push_back(T_world_link[model.linkIndex(marker.link)].translation());
  return positions;
}

}  // namespace markerless_mocap
