#include <ros/ros.h>

#include <string>
#include <vector>

#include "nodes/common/stage_host.h"

// Runs all stages named on the command line in one process, so that messages are passed without
// copies. A nodelet manager is no alternative: the processes that loaded its nodelets unload them,
// and a manager that is stopped together with those processes can crash. --retry as in host_main.
int main(int argc, char** argv) {
  ros::init(argc, argv, "mocap");
  std::vector<markerless_mocap::HostedStage> stages;
  std::vector<std::string> arguments;
  for (const std::string& argument : std::vector<std::string>(argv + 1, argv + argc))
    if (argument.rfind("--", 0) == 0)
      arguments.push_back(argument);
    else
      stages.push_back({ros::names::resolve(argument), "markerless_mocap/" + argument});
  if (stages.empty()) {
    ROS_FATAL("mocap: no stage is given, allowed are names such as silhouette visual_hull");
    return 1;
  }
  return markerless_mocap::runStages(stages, arguments);
}
