#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "markerless_mocap/body/twist.h"

namespace markerless_mocap {

/// A revolute or fixed joint of the tree. The child link's frame has its origin at the joint.
struct BodyJoint {
  std::string name;
  int parent_link = -1;
  int child_link = -1;
  int angle_index = -1;  ///< position in the angle vector; -1 for a fixed joint
  Eigen::Isometry3d T_parent_joint = Eigen::Isometry3d::Identity();  ///< at angle 0
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();                   ///< in the joint's frame
  double lower = 0.0, upper = 0.0;                                   ///< radians
  Twist twist;  ///< of the joint in the root's frame, all angles zero; zero for a fixed joint
};

/// A truncated cone with rounded ends, fixed to a link. The body's shape is a union of such cones.
struct RoundCone {
  int link = 0;
  Eigen::Vector3d a, b;       ///< centres of the two ends in the link's frame, metres
  double radius_a, radius_b;  ///< metres
  Eigen::Vector3f rgb = Eigen::Vector3f::Constant(0.7f);  ///< material colour, each 0 to 1
};

/// Result of forward kinematics: one frame per link.
using LinkPoses = std::vector<Eigen::Isometry3d>;

/// The URDF body: kinematic tree, joint limits, shape. Immutable; may be shared by threads.
class BodyModel {
 public:
  /// Parses a URDF whose links and joints end in "_<id>". A cylinder becomes a round cone with two
  /// equal radii, a sphere a round cone of length 0. Spheres inside the rounded end of a cylinder
  /// add nothing and are left out. Other visuals are ignored. Throws std::invalid_argument if the
  /// text is no URDF, if a link or joint of REP-155 is missing or of a wrong type, or if a joint's
  /// limits are an empty range; the message names the link or joint.
  static BodyModel fromUrdf(const std::string& urdf_xml, const std::string& id);

  const std::string& id() const { return id_; }
  /// Full names; the root is first, parents precede children.
  const std::vector<std::string>& links() const { return links_; }
  /// Joint i leads to link i + 1.
  const std::vector<BodyJoint>& joints() const { return joints_; }
  const std::vector<RoundCone>& shape() const { return shape_; }
  int angleCount() const { return angle_count_; }
  /// Index by base name ("l_elbow", without the id); throws std::invalid_argument if absent.
  int linkIndex(const std::string& base_name) const;
  int angleIndex(const std::string& joint_base_name) const;
  const BodyJoint& joint(const std::string& base_name) const;

  /// Joint names in the order of the angle vector.
  std::vector<std::string> angleNames() const;

  /// Frames of all links in the world, by products of exponentials along the tree (Hsiao 2008, Eq.
  /// 3-17 to 3-26). Allocates no memory if `T_world_link` already has its size.
  /// \param angles radians, in the order of angleNames(); throws std::invalid_argument unless
  ///   angleCount() values are given
  void forwardKinematics(const Eigen::Isometry3d& T_world_root, const Eigen::VectorXd& angles,
                         LinkPoses& T_world_link) const;

 private:
  std::string id_;
  std::vector<std::string> links_;
  std::vector<BodyJoint> joints_;
  std::vector<RoundCone> shape_;
  std::vector<Eigen::Isometry3d> T_root_link_zero_;  ///< g(0) of each link: all angles zero
  int angle_count_ = 0;
};

/// Names of the fifteen joint centres of the error measure (Fleischmann 2012, Eq. 4.4), in a fixed
/// order.
const std::vector<std::string>& markerNames();
/// World positions of markerNames(), metres.
std::vector<Eigen::Vector3d> markerPositions(const BodyModel& model, const LinkPoses& T_world_link);

}  // namespace markerless_mocap
