#include "ros/truth_conversions.h"

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
  message.positions.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    message.positions[i].x = points[i].x();
    message.positions[i].y = points[i].y();
    message.positions[i].z = points[i].z();
  }
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
