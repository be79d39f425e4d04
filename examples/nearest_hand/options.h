#pragma once

#include <ros/node_handle.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

struct Options {
  std::string robot_frame = "tool0";
  std::vector<std::string> poses{"pose"};  // topics, one for each person that is tracked
  double hand_length = 0.2;                // from the wrist to the finger tips, m
  double reach = 1.1;               // from midway between the shoulders to the finger tips, m
  double margin_deviations = 3.0;   // margin in expected errors
  double max_age = 0.3;             // of a pose, s
  double human_speed = 1.6;         // towards the robot, at least, m/s
  double robot_speed = 0.25;        // towards the hand, m/s
  double reaction_time = 0.1;       // of what reads this and of the robot's control, s
  double stopping_time = 0.3;       // of the robot, s
  double stopping_distance = 0.05;  // of the robot, m
  double intrusion_distance = 0.0;  // m, and what belongs to the tool around the robot's frame
  double robot_error = 0.005;       // of the robot's own position, m
};

/// Throws std::invalid_argument if a value cannot be.
inline Options readOptions(const ros::NodeHandle& handle) {
  Options o;
  handle.getParam("robot_frame", o.robot_frame);
  handle.getParam("poses", o.poses);
  const std::pair<const char*, double*> numbers[] = {{"hand_length", &o.hand_length},
                                                     {"reach", &o.reach},
                                                     {"max_age", &o.max_age},
                                                     {"margin_deviations", &o.margin_deviations},
                                                     {"human_speed", &o.human_speed},
                                                     {"robot_speed", &o.robot_speed},
                                                     {"reaction_time", &o.reaction_time},
                                                     {"stopping_time", &o.stopping_time},
                                                     {"robot_error", &o.robot_error},
                                                     {"stopping_distance", &o.stopping_distance},
                                                     {"intrusion_distance", &o.intrusion_distance}};
  for (const auto& [name, value] : numbers) {
    handle.getParam(name, *value);
    if (!(*value >= 0.0 && std::isfinite(*value)))
      throw std::invalid_argument(std::string(name) + " must be a number of at least 0");
  }
  if (o.poses.empty()) throw std::invalid_argument("poses must name a topic");
  return o;
}
