#pragma once

#include <geometry_msgs/Point.h>
#include <markerless_mocap/JointPositions.h>
#include <sensor_msgs/JointState.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// \param points metres, one per name; throws std::invalid_argument if the numbers differ
JointPositions messageFromPoints(const std::vector<std::string>& names,
                                 const std::vector<Eigen::Vector3d>& points,
                                 const std_msgs::Header& header);

/// All joint angles of a body (radians), in the order of angleNames(). Throws std::invalid_argument
/// if the number of angles is wrong.
sensor_msgs::JointState messageFromAngles(const BodyModel& model, const Eigen::VectorXd& angles,
                                          const std_msgs::Header& header);

}  // namespace markerless_mocap
