#include <nodelet/loader.h>
#include <ros/ros.h>

// Runs one nodelet in a process of its own. The node has the name of the stage. It returns 1 if the
// nodelet rejects its parameters.
int main(int argc, char** argv) {
  ros::init(argc, argv, MOCAP_NODE);
  nodelet::Loader loader;
  const nodelet::V_string arguments(argv + 1, argv + argc);
  if (!loader.load(ros::this_node::getName(), MOCAP_NODELET, ros::names::getRemappings(),
                   arguments))
    return 1;
  ros::spin();
  return 0;
}
