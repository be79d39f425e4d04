#include "nodes/common/stage_host.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <nodelet/loader.h>
#include <ros/ros.h>

#include <algorithm>
#include <cstdlib>

#include "nodes/common/guarded_start.h"
#include "nodes/common/keep_memory.h"
#include "nodes/common/master_watch.h"
#include "nodes/common/process_limits.h"

namespace markerless_mocap {
namespace {

constexpr int kRetryInterval = 5;  // s

bool loadAll(nodelet::Loader* loader, const std::vector<HostedStage>& stages,
             const std::vector<std::string>& arguments) {
  for (const HostedStage& stage : stages)
    if (!loader->load(stage.name, stage.type, ros::names::getRemappings(), arguments)) {
      loader->clear();
      return false;
    }
  return true;
}

diagnostic_msgs::DiagnosticArray refusal() {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  diagnostic_msgs::DiagnosticStatus status;
  status.level = diagnostic_msgs::DiagnosticStatus::ERROR;
  status.name = ros::this_node::getName().substr(1) + ": start";
  const char* sentence = std::getenv(kRefusalVariable);
  status.message = sentence ? sentence : "the stage cannot be loaded, see the log";
  array.status.push_back(status);
  return array;
}

void waitAsRefused(const ros::Publisher& diagnostics) {
  for (int i = 0; i < kRetryInterval && ros::ok(); ++i) {
    diagnostics.publish(refusal());
    ros::WallDuration(1.0).sleep();
    ros::spinOnce();
  }
}

}  // namespace

int runStages(const std::vector<HostedStage>& stages, const std::vector<std::string>& arguments) {
  keepFreedMemory();
  std::vector<std::string> rest = arguments;
  rest.erase(std::remove(rest.begin(), rest.end(), "--retry"), rest.end());
  const bool retries = rest.size() < arguments.size();
  if (const std::string cut = raiseFileSizeLimit(); !cut.empty())
    ROS_WARN_STREAM(ros::this_node::getName() << ": " << cut);
  if (const std::string lack = raiseProcessLimits(); !lack.empty()) {
    ROS_FATAL_STREAM(ros::this_node::getName() << ": " << lack);
    if (retries) ros::WallDuration(kRetryInterval).sleep();  // a launch file starts it again
    return 1;
  }
  ros::NodeHandle handle;
  nodelet::Loader loader(false);
  ros::Publisher diagnostics;
  while (!loadAll(&loader, stages, rest)) {
    if (!retries) return 1;
    if (!diagnostics)
      diagnostics = handle.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1);
    waitAsRefused(diagnostics);
    if (!ros::ok()) return 1;
  }
  diagnostics.shutdown();
  std::vector<std::string> namespaces;
  for (const HostedStage& stage : stages) namespaces.push_back(stage.name);
  const MasterWatch watch(namespaces);
  ros::spin();
  return 0;
}

}  // namespace markerless_mocap
