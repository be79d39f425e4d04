#include <ros/ros.h>

#include "nodes/common/stage_host.h"

// Runs one nodelet in a process of its own. The node has the name of the stage. It returns 1 if the
// nodelet rejects its parameters; with --retry it says so and waits for better ones.
int main(int argc, char** argv) {
  ros::init(argc, argv, MOCAP_NODE);
  return markerless_mocap::runStages({{ros::this_node::getName(), MOCAP_NODELET}},
                                     {argv + 1, argv + argc});
}
