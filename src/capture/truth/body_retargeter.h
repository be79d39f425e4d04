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

/// Segment lengths of the URDF body that has this skeleton's joints.
BodyProportions proportionsOf(const HumanSkeleton& skeleton);

/// Moves the URDF body as a person moves. The root is the pelvis; every other joint points its limb
/// at the person's next joint, so positions agree where the body has the axes and the limits for it
/// (its spine is one joint without twist, its hands are rigid, its feet turn up and down).
/// Three-axis joints are decomposed exactly; of several solutions the one nearest to the last pose
/// within the limits is taken.
class BodyRetargeter {
 public:
  /// \param model filled with proportionsOf(skeleton)
  BodyRetargeter(std::shared_ptr<const BodyModel> model, HumanSkeleton skeleton);

  /// Follows the next pose of a motion.
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

/// Distance between the fifteen joints of the driven body and the person's, metres: the mean.
double meanJointDistance(const BodyModel& model, const BodyState& state,
                         const HumanSkeleton& skeleton, const HumanPose& pose);

}  // namespace markerless_mocap
