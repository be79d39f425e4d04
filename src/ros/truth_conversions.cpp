#include "ros/truth_conversions.h"

#include <tf2_eigen/tf2_eigen.h>

#include <stdexcept>

namespace markerless_mocap {

JointPositions messageFromPoints(const std::vector<std::string>& names,
                                 const std::vector<Eigen::Vector3d>& points,
                                 const std_msgs::Header& header) {
  if (names.size() != points.size())
    throw std::invalid_argument(std::to_string(names.size()) + " names for " +
                                std::to_string(points.size()) + " points");
  JointPositions message;
  message.header = header;
  message.names = names;
  for (const Eigen::Vector3d& point : points) message.positions.push_back(tf2::toMsg(point));
  return message;
}

sensor_msgs::JointState messageFromAngles(const BodyModel& model, const Eigen::VectorXd& angles,
                                          const std_msgs::Header& header) {
  if (angles.size() != model.angleCount())
    throw std::invalid_argument(std::to_string(angles.size()) + " angles for a body of " +
                                std::to_string(model.angleCount()));
  sensor_msgs::JointState state;
  state.header = header;
  state.name = model.angleNames();
  state.position.assign(angles.data(), angles.data() + angles.size());
  return state;
}

}  // namespace markerless_mocap
