#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "capture/body_state.h"
#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/body/body_urdf.h"
#include "motion/human_pose.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Segment lengths of the URDF body with the joints of this skeleton.
BodyProportions proportionsOf(const HumanSkeleton& skeleton);

/// Retargets a person's motion to the URDF body. The root is the pelvis. Each other joint points
/// its limb at the person's next joint, so positions agree as far as the body has the axes and
/// limits for it: its spine is one joint without twist, its hands are rigid, and its feet only
/// pitch. Spherical joints are decomposed exactly; of several solutions the one within the limits
/// that is nearest to the last pose is taken.
class BodyRetargeter {
 public:
  /// \param model body with proportionsOf(skeleton)
  BodyRetargeter(std::shared_ptr<const BodyModel> model, HumanSkeleton skeleton);

  /// The state of the body for the next pose of a motion.
  BodyState follow(const HumanPose& pose);

 private:
  struct Limb;

  Eigen::Matrix3d linkRotation(int link) const { return T_world_link_[size_t(link)].linear(); }
  void forward(const BodyState& state);
  void aim(const std::string& first, const std::string& second, const Eigen::Vector3d& rest,
           const Eigen::Vector3d& target, Eigen::VectorXd& angles) const;
  void turn(const std::array<std::string, 3>& joints, const Eigen::Matrix3d& R_world,
            Eigen::VectorXd& angles) const;
  void setLimb(const Limb& limb, const HumanPose& pose, const PerBone<Eigen::Vector3d>& joints,
               Eigen::VectorXd& angles) const;
  void setFoot(const std::string& ankle, const Eigen::Vector3d& forward,
               Eigen::VectorXd& angles) const;
  void setHead(const HumanPose& pose, const PerBone<Eigen::Vector3d>& joints,
               Eigen::VectorXd& angles) const;
  void setAngle(const std::string& joint, double angle, Eigen::VectorXd& angles) const;

  std::shared_ptr<const BodyModel> model_;
  HumanSkeleton skeleton_;
  Eigen::VectorXd last_;
  LinkPoses T_world_link_;
};

}  // namespace markerless_mocap
