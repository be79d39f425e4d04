#include "body/zero_pose.h"

#include <stdexcept>

namespace markerless_mocap {

LinkPoses zeroPose(const BodyModel& model) {
  LinkPoses zero;
  model.forwardKinematics(Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(model.angleCount()),
                          zero);
  return zero;
}

LinkPoses uprightZeroPose(const BodyModel& model) {
  LinkPoses zero = zeroPose(model);
  for (size_t i = 0; i < zero.size(); ++i)
    if (!zero[i].linear().isIdentity(1e-9))
      throw std::invalid_argument("body " + model.id() + ": link " + model.links()[i] +
                                  " is rotated in the zero pose, all must have the root's axes");
  return zero;
}

}  // namespace markerless_mocap
