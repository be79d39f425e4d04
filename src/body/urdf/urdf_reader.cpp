#include "body/urdf/urdf_reader.h"

#include <tinyxml2.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <stdexcept>

#include "files/xml_text.h"
#include "numerics/segment.h"

namespace markerless_mocap {
namespace {

constexpr const char* kSubject = "URDF of the body";  // of sentences

enum class Kind { kFixed, kRevolute, kEither };

/// A joint of the angle vector, in its order. REP-155 has all joints but the optional ones; its
/// ankles are fixed.
struct KnownJoint {
  const char* name;
  const char* child;
  Kind kind;
  bool optional;
};
constexpr KnownJoint kKnownJoints[] = {{"waist", "waist", Kind::kRevolute, false},
                                       {"r_waist", "r_waist", Kind::kRevolute, true},
                                       {"torso", "torso", Kind::kFixed, false},
                                       {"r_head", "r_head", Kind::kRevolute, false},
                                       {"y_head", "y_head", Kind::kRevolute, false},
                                       {"p_head", "p_head", Kind::kRevolute, false},
                                       {"head", "head", Kind::kFixed, false},
                                       {"l_y_clavicle", "l_y_clavicle", Kind::kRevolute, true},
                                       {"l_r_clavicle", "l_r_clavicle", Kind::kRevolute, true},
                                       {"l_y_shoulder", "l_y_shoulder", Kind::kRevolute, false},
                                       {"l_p_shoulder", "l_p_shoulder", Kind::kRevolute, false},
                                       {"l_r_shoulder", "l_shoulder", Kind::kRevolute, false},
                                       {"l_elbow", "l_elbow", Kind::kRevolute, false},
                                       {"l_wrist", "l_wrist", Kind::kFixed, false},
                                       {"r_y_clavicle", "r_y_clavicle", Kind::kRevolute, true},
                                       {"r_r_clavicle", "r_r_clavicle", Kind::kRevolute, true},
                                       {"r_y_shoulder", "r_y_shoulder", Kind::kRevolute, false},
                                       {"r_p_shoulder", "r_p_shoulder", Kind::kRevolute, false},
                                       {"r_r_shoulder", "r_shoulder", Kind::kRevolute, false},
                                       {"r_elbow", "r_elbow", Kind::kRevolute, false},
                                       {"r_wrist", "r_wrist", Kind::kFixed, false},
                                       {"l_y_hip", "l_y_hip", Kind::kRevolute, false},
                                       {"l_p_hip", "l_p_hip", Kind::kRevolute, false},
                                       {"l_r_hip", "l_hip", Kind::kRevolute, false},
                                       {"l_knee", "l_knee", Kind::kRevolute, false},
                                       {"l_ankle", "l_ankle", Kind::kEither, false},
                                       {"r_y_hip", "r_y_hip", Kind::kRevolute, false},
                                       {"r_p_hip", "r_p_hip", Kind::kRevolute, false},
                                       {"r_r_hip", "r_hip", Kind::kRevolute, false},
                                       {"r_knee", "r_knee", Kind::kRevolute, false},
                                       {"r_ankle", "r_ankle", Kind::kEither, false}};

[[noreturn]] void refuse(const std::string& message) {
  throw std::invalid_argument(std::string(kSubject) + ": " + message);
}

/// What is read afterwards recurses into tags and links, and its stack is limited.
void checkTags(const std::string& xml) {
  constexpr auto kMaxTags = 10000;
  if (const auto tags = std::count(xml.begin(), xml.end(), '<'); tags > kMaxTags)
    refuse("it has " + std::to_string(tags) + " tags, allowed are " + std::to_string(kMaxTags));
}

/// The URDF reader says of broken XML neither where nor what.
void checkXml(const std::string& xml) {
  tinyxml2::XMLDocument document;
  readXml(xml, kSubject, &document);
}

std::string textOf(Kind kind) {
  return kind == Kind::kEither     ? "revolute or fixed"
         : kind == Kind::kRevolute ? "revolute"
                                   : "fixed";
}

Eigen::Isometry3d toIsometry(const urdf::Pose& pose) {
  constexpr double kFarthest = 1000.0;  // metres
  const urdf::Rotation& r = pose.rotation;
  const Eigen::Vector3d position(pose.position.x, pose.position.y, pose.position.z);
  const Eigen::Quaterniond rotation(r.w, r.x, r.y, r.z);
  if (!(position.norm() < kFarthest) || !(rotation.norm() > 0.5))  // false for NaN
    refuse("an origin is not finite or farther than 1000 m");
  return Eigen::Translation3d(position) * rotation.normalized();
}

void checkJoint(const urdf::ModelInterface& urdf, const KnownJoint& known, const std::string& id) {
  const std::string name = std::string(known.name) + "_" + id;
  const std::string child = std::string(known.child) + "_" + id;
  const auto joint = urdf.getJoint(name);
  if (!joint) {
    if (known.optional) return;
    refuse("joint " + name + " is missing");
  }
  if (!urdf.getLink(child)) refuse("link " + child + " is missing");
  if (joint->child_link_name != child)
    refuse("joint " + name + " leads to link " + joint->child_link_name + ", it must lead to " +
           child);
  const bool moves = joint->type == urdf::Joint::REVOLUTE;
  const bool fixed = joint->type == urdf::Joint::FIXED;
  if (!(moves && known.kind != Kind::kFixed) && !(fixed && known.kind != Kind::kRevolute))
    refuse("joint " + name + " must be " + textOf(known.kind));
}

/// Rank of a joint in the order of angles; unknown joints come last.
size_t rank(const std::string& joint_name, const std::string& id) {
  size_t i = 0;
  while (i < std::size(kKnownJoints) && kKnownJoints[i].name + ("_" + id) != joint_name) ++i;
  return i;
}

Eigen::Vector3d checkedAxis(const urdf::Joint& joint) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  if (!(axis.norm() > 1e-9)) refuse("joint " + joint.name + " has no axis");
  return axis.normalized();
}

void setMotion(const urdf::Joint& from, BodyJoint& joint) {
  if (from.type == urdf::Joint::FIXED) return;
  if (from.type != urdf::Joint::REVOLUTE)
    refuse("joint " + from.name + " must be revolute or fixed");
  if (!(from.limits->lower < from.limits->upper))
    refuse("joint " + from.name + " must have a lower limit below its upper limit");
  joint.axis = checkedAxis(from);
  joint.lower = from.limits->lower;
  joint.upper = from.limits->upper;
}

/// Whether a sphere lies inside a capsule and adds nothing to the shape.
bool within(const RoundCone& sphere, const RoundCone& capsule) {
  constexpr double kSlack = 1e-6;
  const Eigen::Vector3d along = capsule.b - capsule.a;
  if (along.isZero(0)) return false;
  const double s = nearestFraction(sphere.a, capsule.a, along);
  const double distance = (capsule.a + s * along - sphere.a).norm();
  return distance + sphere.radius_a <= capsule.radius_a + kSlack;
}

/// The visuals of a link as round cones.
std::vector<RoundCone> readShape(const urdf::Link& link, int index) {
  constexpr double kMaxSize = 100.0;  // metres
  std::vector<RoundCone> cones;
  for (const auto& visual : link.visual_array) {
    const Eigen::Isometry3d T_link_visual = toIsometry(visual->origin);
    Eigen::Vector3d half = Eigen::Vector3d::Zero();
    double radius = 0.0;
    if (const auto c = std::dynamic_pointer_cast<urdf::Cylinder>(visual->geometry)) {
      half = T_link_visual.linear().col(2) * (c->length / 2.0);
      radius = c->radius;
    } else if (const auto s = std::dynamic_pointer_cast<urdf::Sphere>(visual->geometry)) {
      radius = s->radius;
    }
    if (!(radius > 0.0)) continue;
    if (!(radius < kMaxSize && half.norm() < kMaxSize))
      refuse("link " + link.name + " has a shape larger than " + std::to_string(int(kMaxSize)) +
             " m");
    const Eigen::Vector3d center = T_link_visual.translation();
    cones.push_back({index, center + half, center - half, radius, radius});
    if (visual->material) {
      const urdf::Color& color = visual->material->color;
      cones.back().rgb = {color.r, color.g, color.b};
    }
  }
  std::vector<RoundCone> kept;
  for (const RoundCone& cone : cones)
    if (cone.a != cone.b || std::none_of(cones.begin(), cones.end(), [&](const RoundCone& other) {
          return within(cone, other);
        }))
      kept.push_back(cone);
  return kept;
}

/// Returns its index.
int appendLink(const urdf::Link& link, BodyTree& tree) {
  const int index = int(tree.links.size());
  if (std::find(tree.links.begin(), tree.links.end(), link.name) != tree.links.end())
    refuse("link " + link.name + " is the child of more than one joint");
  tree.links.push_back(link.name);
  const std::vector<RoundCone> cones = readShape(link, index);
  tree.shape.insert(tree.shape.end(), cones.begin(), cones.end());
  return index;
}

/// The joint to the link that is appended next.
void appendJoint(const urdf::Joint& from, int parent_link, int& angle_count, BodyTree& tree) {
  BodyJoint joint;
  joint.name = from.name;
  joint.parent_link = parent_link;
  joint.child_link = int(tree.links.size());
  joint.T_parent_joint = toIsometry(from.parent_to_joint_origin_transform);
  setMotion(from, joint);
  if (from.type == urdf::Joint::REVOLUTE) joint.angle_index = angle_count++;
  tree.joints.push_back(joint);
}

/// A link that is to be appended, and the joint that leads to it; none to the root.
struct PendingLink {
  urdf::LinkConstSharedPtr link;
  urdf::JointConstSharedPtr from;
  int parent_link;
};

/// Appends the root and its descendants, depth first; without recursion, as foreign chains are
/// long.
void appendLinks(const urdf::LinkConstSharedPtr& root, const std::string& id, BodyTree& tree) {
  int angle_count = 0;
  std::vector<PendingLink> pending{{root, nullptr, -1}};
  while (!pending.empty()) {
    const PendingLink next = pending.back();
    pending.pop_back();
    if (next.from) appendJoint(*next.from, next.parent_link, angle_count, tree);
    const int index = appendLink(*next.link, tree);
    std::vector<urdf::JointSharedPtr> children = next.link->child_joints;
    std::stable_sort(children.begin(), children.end(), [&](const auto& a, const auto& b) {
      return rank(a->name, id) < rank(b->name, id);
    });
    std::reverse(children.begin(), children.end());
    for (const auto& from : children)
      for (const auto& child : next.link->child_links)
        if (child->name == from->child_link_name) pending.push_back({child, from, index});
  }
}

}  // namespace

BodyTree readBodyTree(const std::string& urdf_xml, const std::string& id) {
  checkTags(urdf_xml);
  checkXml(urdf_xml);
  const urdf::ModelInterfaceSharedPtr urdf = urdf::parseURDF(urdf_xml);
  if (!urdf || !urdf->getRoot())
    refuse(
        "the text is XML, but no URDF: needed is a robot whose links hang on one root, each by one "
        "joint, with numbers where numbers belong");
  const std::string root = "body_" + id;
  if (!urdf->getLink(root)) refuse("link " + root + " is missing");
  if (urdf->getRoot()->name != root)
    refuse("its root is " + urdf->getRoot()->name + ", it must be " + root);
  for (const KnownJoint& known : kKnownJoints) checkJoint(*urdf, known, id);
  BodyTree tree;
  appendLinks(urdf->getRoot(), id, tree);
  return tree;
}

}  // namespace markerless_mocap
